# Every line is a command that a person could type. `make` alone lists the targets.
SHELL := /bin/bash
PYTEST := .venv/bin/python -m pytest
ROS := source scripts/environment.bash &&
SLOW := -m 'slow or not slow'

.DEFAULT_GOAL := help
.PHONY: help setup build demo test test-all lint core-tests ros-tests bench train docs clean

help:  ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1\t\2/p' Makefile | expand -t 18

setup:  ## put what is missing into .venv
	@scripts/setup.sh

build: setup  ## build the ROS 2 workspace
	@scripts/build.sh

demo: build  ## watch a robot cross a crowd: 5 episodes over ROS 2; REAL_TIME=1 paces it
	@$(ROS) ros2 run socialnav demo --scenario hard --episodes 5 --out out/demo $(if $(REAL_TIME),--real-time)

lint: setup  ## style, types, spelling
	.venv/bin/ruff check .
	.venv/bin/ruff format --check .
	.venv/bin/mypy
	.venv/bin/codespell

core-tests: setup  ## tests of socialnav_core
	$(PYTEST) tests $(OPTIONS)

ros-tests: build  ## tests of the ROS packages, over the real middleware; the demo is the last
	$(ROS) $(PYTEST) ros_ws/wheels/test $(OPTIONS)
	$(ROS) $(PYTEST) ros_ws/src/socialnav/test $(OPTIONS)

test: lint core-tests ros-tests  ## everything that CI runs

test-all:  ## the same with the long tests
	$(MAKE) test OPTIONS="$(SLOW)"

bench: setup  ## speed, as ratios against a plain reference in the same run
	.venv/bin/socialnav benchmark all

train: setup  ## train the default model from its config
	.venv/bin/socialnav train socialnav_core/configs/sarl.yaml --out out/sarl

docs: setup  ## regenerate the model cards from their metrics
	.venv/bin/socialnav models --cards

clean:  ## remove everything that was built, installed or written
	rm -rf .venv out ros_ws/build ros_ws/install ros_ws/log *.egg-info
