# Every line is a command that a person could type; `make` alone lists the targets. Whatever is missing is installed
# into .venv first, with ROS 2 Jazzy from where it is sourced, else from wheels.
SHELL := /bin/bash
RUN := source scripts/environment.bash &&

.DEFAULT_GOAL := help
.PHONY: help setup build demo demo-sensors test test-all lint bench train docs clean

help:  ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1\t\2/p' Makefile | expand -t 18

setup:  ## put what is missing into .venv
	@scripts/setup.sh

build: setup  ## build the ROS 2 workspace into ros_ws/install
	@scripts/build.sh

demo: build  ## drive a robot through a crowd over ROS 2, five episodes; REAL_TIME=1 paces it
	@$(RUN) ros2 run socialnav demo --scenario hard --episodes 5 --out out/demo $(if $(filter 1,$(REAL_TIME)),--real-time)

demo-sensors: build  ## the same with a laser scan and detections as all that the policy is told
	@$(RUN) ros2 run socialnav demo --sensors --scenario hard --episodes 5 --out out/demo_sensors

test: setup  ## everything that continuous integration runs; OPTIONS go to pytest
	@scripts/test.sh $(OPTIONS)

test-all: setup  ## the same with the long tests
	@scripts/test.sh -m 'slow or not slow' $(OPTIONS)

lint: setup  ## style, types, spelling, the Dockerfiles
	.venv/bin/ruff check .
	.venv/bin/ruff format --check .
	.venv/bin/mypy
	.venv/bin/codespell
	.venv/bin/hadolint docker/Dockerfile docker/nav2.Dockerfile

bench: setup  ## speed, as ratios against a plain reference in the same run
	.venv/bin/socialnav benchmark all

train: setup  ## train the default model from its config
	.venv/bin/socialnav train socialnav_core/config/recipes/sarl.yaml --out out/sarl

docs: build  ## regenerate the model cards, the pages of metrics, settings and faults, and the tables of parameters in the nodes' README
	.venv/bin/socialnav models --cards
	.venv/bin/socialnav metrics --markdown > docs/metrics.md
	.venv/bin/socialnav settings > docs/settings.md
	@$(RUN) python -m socialnav.parameters.readme ros_ws/src/socialnav/README.md
	@$(RUN) cd ros_ws/src/socialnav/test && python -m helpers.faults $(CURDIR)/docs/faults.md

clean:  ## remove what was installed and built; what was trained or written to out/ stays
	rm -rf .venv ros_ws/build ros_ws/install ros_ws/log *.egg-info .mypy_cache .pytest_cache .ruff_cache
