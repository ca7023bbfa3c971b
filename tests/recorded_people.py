"""Write the synthetic recording that tests use: `python tests/recorded_people.py > FILE`."""

import numpy as np

FRAMES, STEP, INTERVAL = 250, 10, 0.4
"""Annotated frames, their numbers' distance, and the time between two, s."""
LENGTH, WIDTH = 16.0, 9.0
"""Of the street, m."""
NOTE = '# Synthetic people in a street, written by tests/recorded_people.py: frame person x y (m)'


def walks(generator):
    """Yield frames and places, m, of each person: walkers, pairs and one who waits."""
    for _ in range(70):
        begin = int(generator.integers(-20, FRAMES - 20))
        speed, side = generator.uniform(0.8, 1.5), generator.choice([-1, 1])
        line, sway = generator.uniform(1.0, WIDTH - 1.0), generator.uniform(0.0, 0.5)
        frames = np.arange(begin, begin + int(LENGTH / speed / INTERVAL))
        way = (frames - begin) * INTERVAL * speed
        along = way if side > 0 else LENGTH - way
        place = np.stack([along, line + sway * np.sin(0.6 * way)], axis=1)
        company = [0.0, 0.7] if generator.random() < 0.2 else [0.0]
        for offset in company:
            kept = (frames >= 0) & (frames < FRAMES)
            yield frames[kept], (place + (0.0, offset))[kept]
    frames = np.arange(40, 140)
    yield frames, np.tile((8.0, 2.0), (len(frames), 1)) + 0.02 * np.sin(frames)[:, None]


def lines():
    """Yield the lines of the file, frame by frame."""
    yield NOTE
    rows = [
        (int(frame), person, *place)
        for person, (frames, places) in enumerate(walks(np.random.default_rng(1)), 1)
        for frame, place in zip(frames, places, strict=True)
    ]
    for frame, person, x, y in sorted(rows):
        yield f'{STEP * frame} {person} {x:.2f} {y:.2f}'


if __name__ == '__main__':
    print('\n'.join(lines()))
