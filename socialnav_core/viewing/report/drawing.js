'use strict';
// Draws a moment of an episode on a canvas. An episode holds, in whole centimetres (see playback.py):
//   times      time of each state, s            robot      x, y of the robot in each state, one row
//   people     for each state x, y of each      sizes      their radii: once, or for each state
//   obstacles  x, y, radius of each             attention  per cent for each person, then obstacle
//   plan       for each decision x, y, ...      predicted  for each decision: offsets of each person
//   actions    for each decision where actions lead (offsets) and their values (0 to 100, -1: screened)

// The value of a series at a state, or between two of them.
function between(value, at, last) {
  const k = Math.floor(at);
  if (k >= last) return value(last);
  return value(k) + (at - k) * (value(k + 1) - value(k));
}

function makeStage(canvas) {
  const JUMP = 150; // cm between two states: nobody walks so fast, it is another person
  const TRAIL = 8; // steps that the paths of people reach back
  const pen = canvas.getContext('2d');
  const colours = {};
  let episode = null; // what is drawn
  let half = 0; // half the side of what is seen, cm
  let moment = 0; // at which state; between two states a fraction

  function last() { return episode.times.length - 1; }

  function readColours() {
    const style = getComputedStyle(document.documentElement);
    ['floor', 'outside', 'grid', 'wall', 'robot', 'person', 'obstacle', 'goal', 'attention', 'predicted',
      'plan', 'actions', 'ink', 'faint'].forEach((name) => {
      colours[name] = style.getPropertyValue(`--${name}`).trim();
    });
  }

  // Half the side of the square that shows everything, cm.
  function reach() {
    if (episode.bounds !== null) return 1.04 * episode.bounds;
    const places = [episode.robot, episode.goal, ...episode.people].flat(); // null is taken as 0
    return places.reduce((most, place) => Math.max(most, Math.abs(place)), 0) + 60;
  }

  // on: whether a layer is shown, by its name
  function draw(shown, at, on) {
    if (shown !== episode) {
      episode = shown;
      half = reach();
    }
    moment = at;
    const side = canvas.clientWidth * (window.devicePixelRatio || 1);
    if (canvas.width !== Math.round(side)) canvas.width = canvas.height = Math.round(side);
    const scale = canvas.width / (2 * half);
    pen.setTransform(scale, 0, 0, -scale, canvas.width / 2, canvas.width / 2); // x right, y up, cm
    const pixel = (window.devicePixelRatio || 1) / scale; // one pixel of the page, cm
    const k = Math.min(Math.floor(moment), last() - 1); // the decision under way
    drawGround(pixel);
    episode.obstacles.forEach(([x, y, r]) => disc(x, y, r, colours.obstacle, 1));
    drawGoal(pixel);
    const [x, y] = robotAt(moment);
    if (on('trails')) drawTrails(pixel);
    if (on('predicted') && episode.predicted[k]) drawPredicted(k, pixel);
    if (on('attention') && episode.attention[k]) drawAttention(k, x, y, pixel);
    if (on('plan') && episode.plan[k]) line([...robotAt(k), ...episode.plan[k]], colours.plan, 3 * pixel, 1, true);
    drawPeople(pixel);
    drawRobot(x, y, pixel);
    if (on('actions') && episode.actions[k]) drawActions(k, pixel);
    if (on('attention') && episode.attention[k]) writeAttention(k, x, y, pixel);
    if (moment >= last() && episode.outcome !== 'goal') ring(x, y, 1.8 * episode.radius, colours.goal, 3 * pixel);
  }

  function drawGround(pixel) {
    pen.fillStyle = colours.outside;
    pen.fillRect(-half, -half, 2 * half, 2 * half);
    const edge = episode.bounds === null ? half : episode.bounds;
    pen.fillStyle = colours.floor;
    pen.fillRect(-edge, -edge, 2 * edge, 2 * edge);
    for (let at = Math.ceil(-edge / 100) * 100; at < edge; at += 100) { // a line each metre
      line([at, -edge, at, edge], colours.grid, pixel, 1);
      line([-edge, at, edge, at], colours.grid, pixel, 1);
    }
    if (episode.bounds === null) return;
    pen.strokeStyle = colours.wall;
    pen.lineWidth = 2.5 * pixel;
    pen.strokeRect(-edge, -edge, 2 * edge, 2 * edge);
  }

  function drawGoal(pixel) {
    const [x, y] = episode.goal;
    ring(x, y, episode.tolerance, colours.goal, 1.5 * pixel);
    pen.beginPath();
    for (let i = 0; i < 10; i += 1) { // a star
      const radius = (i % 2 ? 0.45 : 1) * Math.max(18, 8 * pixel);
      const angle = Math.PI / 2 + i * Math.PI / 5;
      pen.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
    }
    pen.fillStyle = colours.goal;
    pen.fill();
  }

  function drawTrails(pixel) {
    const passed = Math.floor(moment);
    line([...episode.robot.slice(0, 2 * passed + 2), ...robotAt(moment)], colours.robot, 2.5 * pixel, 0.9);
    for (let i = 0; i < count(); i += 1) {
      let path = [];
      for (let k = Math.max(passed - TRAIL, 0); k <= passed; k += 1) {
        const place = stored(k, i);
        if (!place || far(place, path.slice(-2))) path = [];
        if (place) path.push(...place);
      }
      line(path, colours.person, 1.5 * pixel, 0.45);
    }
  }

  function drawPredicted(k, pixel) {
    const points = episode.predicted[k].length / (2 * count() || 1);
    for (let i = 0; i < count(); i += 1) {
      const start = stored(k, i);
      if (!start) continue;
      const path = [...start];
      for (let j = i * points; j < (i + 1) * points; j += 1) {
        path.push(start[0] + episode.predicted[k][2 * j], start[1] + episode.predicted[k][2 * j + 1]);
      }
      line(path, colours.predicted, 1.5 * pixel, 0.8, false, [4 * pixel, 4 * pixel]);
      disc(path[path.length - 2], path[path.length - 1], 2.5 * pixel, colours.predicted, 0.8);
    }
  }

  function otherAt(i) { return i < count() ? personAt(moment, i) : episode.obstacles[i - count()]; }

  // A line from the robot to each agent, the wider the more the policy looks at it.
  function drawAttention(k, x, y, pixel) {
    episode.attention[k].forEach((share, i) => {
      const place = otherAt(i);
      if (!place || share < 1) return;
      line([x, y, place[0], place[1]], colours.attention, (1 + 0.09 * share) * pixel, 0.15 + 0.006 * share);
    });
  }

  // The share in per cent, on whoever gets much of it.
  function writeAttention(k, x, y, pixel) {
    episode.attention[k].forEach((share, i) => {
      const place = otherAt(i);
      if (place && share >= 10) label(`${share} %`, place[0], place[1] + 14 * pixel, colours.attention, pixel);
    });
  }

  function drawPeople(pixel) {
    for (let i = 0; i < count(); i += 1) {
      const place = personAt(moment, i);
      if (!place) continue;
      const radius = sizesAt(Math.floor(moment))[i];
      disc(place[0], place[1], radius, colours.person, 0.9);
      const after = stored(Math.min(Math.floor(moment) + 1, last()), i);
      if (after && !far(after, place)) { // where it walks
        const angle = Math.atan2(after[1] - place[1], after[0] - place[0]);
        line([place[0], place[1], place[0] + radius * Math.cos(angle), place[1] + radius * Math.sin(angle)],
          colours.floor, 2 * pixel, 0.9);
      }
    }
  }

  function drawRobot(x, y, pixel) {
    disc(x, y, episode.radius, colours.robot, 1);
    ring(x, y, episode.radius, colours.ink, 1.5 * pixel);
    if (!episode.heading.length) return;
    const angle = episode.heading[Math.floor(moment)] * Math.PI / 180;
    line([x, y, x + episode.radius * Math.cos(angle), y + episode.radius * Math.sin(angle)], colours.ink,
      2.5 * pixel, 1);
  }

  // Each action where it would lead in a second: the larger and stronger, the better; the best one ringed.
  function drawActions(k, pixel) {
    const [x, y] = robotAt(k);
    const [places, values] = episode.actions[k];
    values.forEach((value, i) => {
      const at = [x + places[2 * i], y + places[2 * i + 1]];
      if (value < 0) ring(at[0], at[1], 1.5 * pixel, colours.faint, 0.7 * pixel);
      else disc(at[0], at[1], (1 + 0.025 * value) * pixel, colours.actions, 0.2 + 0.008 * value);
    });
    const best = values.indexOf(Math.max(...values));
    ring(x + places[2 * best], y + places[2 * best + 1], 5 * pixel, colours.actions, 2 * pixel);
  }

  // Where somebody is.

  function count() { return episode.people[0].length / 2; }

  function sizesAt(k) { return episode.sizes.length > 1 ? episode.sizes[k] : episode.sizes[0]; }

  function stored(k, i) {
    const place = episode.people[k].slice(2 * i, 2 * i + 2);
    return place[0] === null ? null : place;
  }

  function far(place, other) {
    return other.length > 1 && Math.hypot(place[0] - other[0], place[1] - other[1]) > JUMP;
  }

  function personAt(at, i) {
    const k = Math.floor(at);
    const before = stored(k, i);
    const after = stored(Math.min(k + 1, last()), i);
    if (!before || !after || far(after, before)) return before;
    return [0, 1].map((axis) => before[axis] + (at - k) * (after[axis] - before[axis]));
  }

  function robotAt(at) { return [0, 1].map((axis) => between((k) => episode.robot[2 * k + axis], at, last())); }

  // Shapes.

  function disc(x, y, radius, colour, opacity) {
    pen.globalAlpha = opacity;
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.fillStyle = colour;
    pen.fill();
    pen.globalAlpha = 1;
  }

  function ring(x, y, radius, colour, width) {
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }

  function line(points, colour, width, opacity, dotted, dashes) {
    if (points.length < 4) return;
    pen.globalAlpha = opacity;
    pen.beginPath();
    for (let i = 0; i < points.length; i += 2) pen.lineTo(points[i], points[i + 1]);
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.lineJoin = 'round';
    pen.setLineDash(dashes || []);
    pen.stroke();
    pen.setLineDash([]);
    for (let i = 2; dotted && i < points.length; i += 2) disc(points[i], points[i + 1], width, colour, 1);
    pen.globalAlpha = 1;
  }

  function label(text, x, y, colour, pixel) {
    pen.save();
    pen.translate(x, y);
    pen.scale(pixel, -pixel); // letters stand upright
    pen.font = '12px sans-serif';
    pen.textAlign = 'center';
    pen.lineWidth = 3;
    pen.strokeStyle = colours.floor;
    pen.strokeText(text, 0, 0);
    pen.fillStyle = colour;
    pen.fillText(text, 0, 0);
    pen.restore();
  }

  return { readColours, draw };
}
