'use strict';
// Plays the episodes in #data: loads one, moves through its time, and hears buttons and keys.
(function () {
  const data = JSON.parse(document.getElementById('data').textContent);
  const find = (id) => document.getElementById(id);
  const canvas = find('canvas');
  const stage = makeStage(canvas);
  const buttons = [...document.querySelectorAll('.episode')];
  const layers = [...document.querySelectorAll('[data-layer]')];

  let episode = null; // what is loaded
  let moment = 0; // which state is shown; between two states a fraction
  let playing = false;
  let lastFrame = 0;

  function last() { return episode.times.length - 1; }

  function load(button) {
    const world = data.worlds[button.dataset.world];
    episode = world.episodes[button.dataset.episode];
    buttons.forEach((each) => each.setAttribute('aria-pressed', String(each === button)));
    find('command').textContent = button.dataset.command;
    const ending = button.getAttribute('aria-label').split(': ').pop();
    find('title').textContent = `${episode.policy} in ${world.title}, case ${episode.case}: ${ending}`;
    canvas.setAttribute('aria-label', `Seen from above: ${find('title').textContent} after ` +
      `${episode.times[last()].toFixed(2)} s`);
    find('time').max = last();
    layers.forEach(markAbsent);
    pause();
    show(0);
  }

  // A layer that a policy does not tell of stays in the list, but says so.
  function markAbsent(box) {
    const there = box.dataset.layer === 'trails' || episode[box.dataset.layer].length > 0;
    box.disabled = !there;
    box.parentElement.classList.toggle('absent', !there);
    box.parentElement.title = there ? '' : 'this policy does not tell';
  }

  function show(wanted) {
    moment = Math.min(Math.max(wanted, 0), last());
    find('time').value = Math.floor(moment);
    find('time').setAttribute('aria-valuetext', `${timeAt(moment).toFixed(2)} seconds`);
    readOut();
    draw();
  }

  function timeAt(at) { return between((k) => episode.times[k], at, last()); }

  function draw() {
    if (episode) stage.draw(episode, moment, (layer) => layers.some((box) => box.dataset.layer === layer && box.checked));
  }

  function readOut() {
    const gap = episode.gaps[Math.floor(moment)];
    const near = gap === null ? '' : `, nearest ${Math.max(gap / 100, 0).toFixed(2)} m`;
    find('readout').textContent = `${timeAt(moment).toFixed(2)} s of ` +
      `${episode.times[last()].toFixed(2)} s, step ${Math.floor(moment)} of ${last()}${near}`;
  }

  function play() {
    if (moment >= last()) moment = 0;
    playing = true;
    lastFrame = performance.now();
    button();
    requestAnimationFrame(frame);
  }

  function pause() { playing = false; button(); }

  function button() {
    find('play').textContent = playing ? '❚❚ Pause' : '▶ Play';
    find('play').setAttribute('aria-pressed', String(playing));
  }

  function frame(now) {
    if (!playing) return;
    const k = Math.min(Math.floor(moment), last() - 1);
    const duration = episode.times[k + 1] - episode.times[k]; // s, of the step under way
    const seconds = (now - lastFrame) / 1000 * Number(find('speed').value);
    lastFrame = now;
    show(moment + seconds / duration);
    if (moment >= last()) pause();
    else requestAnimationFrame(frame);
  }

  function step(by) { pause(); show(by > 0 ? Math.floor(moment) + by : Math.ceil(moment) + by); }

  function faster(by) {
    const speed = find('speed');
    speed.selectedIndex = Math.min(Math.max(speed.selectedIndex + by, 0), speed.length - 1);
  }

  const KEYS = {
    ' ': () => (playing ? pause() : play()),
    ArrowLeft: () => step(-1),
    ArrowRight: () => step(1),
    '+': () => faster(1),
    '-': () => faster(-1),
    Home: () => step(-Infinity),
    End: () => step(Infinity),
  };

  // Controls that use a key themselves keep it.
  function onKey(event) {
    const kind = event.target.tagName;
    const taken = kind === 'SELECT' || ((kind === 'BUTTON' || event.target.type === 'checkbox') && event.key === ' ');
    if (!KEYS[event.key] || taken || !episode || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    KEYS[event.key]();
  }

  find('player').addEventListener('keydown', onKey);
  find('play').addEventListener('click', () => (playing ? pause() : play()));
  find('back').addEventListener('click', () => step(-1));
  find('forward').addEventListener('click', () => step(1));
  find('time').addEventListener('input', () => { pause(); show(Number(find('time').value)); });
  canvas.addEventListener('click', () => { canvas.focus(); KEYS[' '](); });
  layers.forEach((box) => box.addEventListener('change', draw));
  buttons.forEach((each) => each.addEventListener('click', () => {
    load(each);
    find('player').scrollIntoView({ block: 'nearest' });
    canvas.focus({ preventScroll: true });
  }));
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { stage.readColours(); draw(); });
  new ResizeObserver(draw).observe(canvas);

  stage.readColours();
  const first = document.querySelector('.episode.bad') || buttons[0];
  if (first) load(first);
}());
