// ---- all together ----

// Without WebGL the page goes on without the view.
function newView() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return null;
  try {
    return new View(element('view'), gl);
  } catch (error) {
    return null;
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}

const darkLook = window.matchMedia('(prefers-color-scheme: dark)');
setLook(darkLook.matches);
const view = newView();
const profile = new Profile(element('profile'), (i) => { play(false); choose(i); });
const list = new ObstacleList(view, (i) => { play(false); choose(i); });
const pointer = view && new Pointer(view, list);
element('slider').max = frames.length - 1;

function choose(i) {
  const frameIndex = Math.min(frames.length - 1, Math.max(0, Math.round(i)));
  if (frameIndex !== state.frame) cutGap(false);  // the plane is that of the place that was shown
  state.frame = frameIndex;
  element('slider').value = state.frame;
  const frame = frames[state.frame];
  if (view) view.show(frame);
  profile.show(state.frame);
  showReadout(frame);
  showClosest(frame);
}

function play(isPlaying) {
  state.isPlaying = isPlaying;
  element('play').textContent = isPlaying ? 'Pause' : 'Play';
  if (!isPlaying) return;
  let time = state.frame >= frames.length - 1 ? 0 : frames[state.frame].time;
  let last = performance.now();
  const step = (now) => {
    if (!state.isPlaying) return;
    time += (now - last) / 1000;
    last = now;
    let i = state.frame >= frames.length - 1 ? 0 : state.frame;
    while (i < frames.length - 1 && frames[i].time < time) ++i;
    choose(i);
    if (i >= frames.length - 1) play(false); else requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function step(count) {
  play(false);
  choose(state.frame + count);
}

function goTightest() {
  play(false);
  choose(data.tightest);
  cutGap(Boolean(data.view.isTightHidden));
  lookCloser(data.view.tightDirection);
}

function lookCloser(direction) {
  view?.lookCloser(frames[state.frame], direction ? vector(direction) : view.eye.offset);
  cut();
}

// Begins or ends the cut through the gap.
function cutGap(isCut) {
  const axis = element('cut-axis');
  if (isCut === (axis.value === 'gap')) return;
  axis.value = isCut ? 'gap' : '';
  cut();
}

let opacityBefore = null;  // of the surroundings, which are whole while the gap is cut

function cut() {
  const axis = element('cut-axis').value, isGap = axis === 'gap';
  element('cut-place').disabled = element('cut-flip').disabled = !axis || isGap;
  if (isGap && opacityBefore === null) {
    opacityBefore = element('opacity').value;
    setOpacity(100);
  } else if (!isGap && opacityBefore !== null) {
    setOpacity(opacityBefore);
    opacityBefore = null;
  }
  view?.cut(axis, element('cut-place').value / 1000, element('cut-flip').checked);
}

function fly(show) {
  cutGap(false);
  if (view) show(view);
}

function setLook(isDark) {
  document.documentElement.dataset.look = isDark ? 'dark' : 'light';
  element('look').textContent = isDark ? 'Light look' : 'Dark look';
}

function drawLegend() {
  const canvas = element('scale');
  drawScale(contextOf(canvas, canvas.clientWidth, canvas.clientHeight), canvas.clientWidth, canvas.clientHeight);
}

function applyLook(isDark) {
  setLook(isDark);
  if (view) view.applyLook();
  profile.fit();
  drawLegend();
}

// The view as it is seen, with readout, scale and labels, as a canvas.
function picture() {
  view.redraw();  // the drawing lasts only until the browser shows it
  const shown = view.renderer.domElement, ratio = shown.width / view.container.clientWidth;
  const canvas = make('canvas', { width: shown.width, height: shown.height });
  const context = canvas.getContext('2d');
  context.drawImage(shown, 0, 0);
  context.scale(ratio, ratio);
  const write = (text, x, y, font, align) => {
    Object.assign(context, { font: font + ' system-ui, sans-serif', textAlign: align, lineWidth: 4, lineJoin: 'round' });
    context.strokeStyle = styleColour('view');
    context.strokeText(text, x, y);
    context.fillStyle = styleColour('ink');
    context.fillText(text, x, y);
  };
  const frame = frames[state.frame];
  write(data.title, 12, 24, 'bold 16px', 'left');
  write([clearanceWords(frame), placeWords(frame), distanceWords(frame)].filter(Boolean).join(', '), 12, 44, '13px', 'left');
  if (frame.between) write(frame.between.join(' to '), 12, 62, '13px', 'left');
  for (const label of view.labels) {
    if (label.hidden) continue;
    const box = label.getBoundingClientRect(), all = view.container.getBoundingClientRect();
    write(label.textContent, box.x + box.width / 2 - all.x, box.y + 13 - all.y, '12px', 'center');
  }
  const scale = element('scale');
  context.drawImage(scale, view.container.clientWidth - scale.clientWidth - 12, 10, scale.clientWidth, scale.clientHeight);
  return canvas;
}

function savePicture() {
  if (!view) return;
  const name = data.title.replace(/[^\w.-]+/g, '_') || 'picture';
  picture().toBlob((blob) => {
    const address = URL.createObjectURL(blob);
    make('a', { href: address, download: `${name}_${state.frame}.png` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  });
}

// ---- controls and keys ----

const kSeeThrough = 25;  // percent
// Where the surroundings hide much of the way, or of the part where it is tightest, they begin see-through.
const kFirstOpacity = data.view.visible < 0.8 || data.view.tightVisible < 0.5 ? kSeeThrough : 100;
const toggle = (id) => () => element(id).click();
const kKeys = [
  [' ', 'space', 'play or pause', toggle('play')],
  ['ArrowLeft', '\u2190', 'one place back', () => step(-1)],
  ['ArrowRight', '\u2192', 'one place on; with shift ten', () => step(1)],
  ['Home', 'Home', 'to the start', () => step(-Infinity)],
  ['End', 'End', 'to the goal', () => step(Infinity)],
  ['t', 't', 'fly to the tightest place', toggle('tightest')],
  ['c', 'c', 'look closer at the closest pair', toggle('closer')],
  ['p', 'p', 'see the part\u2019s way', toggle('way')],
  ['w', 'w', 'see the whole scene', toggle('whole')],
  ['+', '+', 'come nearer', () => view?.eye.turn(0, 1 / 1.2)],
  ['-', '\u2212', 'go farther away', () => view?.eye.turn(0, 1.2)],
  [',', ',', 'turn to the left', () => view?.eye.turn(-0.15, 1)],
  ['.', '.', 'turn to the right', () => view?.eye.turn(0.15, 1)],
  ['g', 'g', 'start and goal as ghosts', toggle('ghosts')],
  ['e', 'e', 'edges', toggle('edges')],
  ['x', 'x', 'surroundings solid or see-through', () => setOpacity(element('opacity').value < 100 ? 100 : kSeeThrough)],
  ['h', 'h', 'hide the obstacle under the pointer', () => pointer?.hideFound()],
  ['a', 'a', 'show all obstacles', toggle('all-obstacles')],
  ['l', 'l', 'logarithmic profile', toggle('log')],
  ['d', 'd', 'dark or light look', toggle('look')],
  ['s', 's', 'save a picture of the view', toggle('save')],
  ['?', '?', 'this help', toggle('help-button')],
];

function setOpacity(percent) {
  element('opacity').value = percent;
  if (view) view.seeThrough(percent / 100);
}

// Keys that the focused control uses itself are left to it.
function isTaken(event) {
  const { tagName, type } = event.target;
  if (event.ctrlKey || event.altKey || event.metaKey || element('help').open) return true;
  if (tagName === 'SELECT' || tagName === 'TEXTAREA') return true;
  if (event.key === ' ') return tagName === 'BUTTON' || type === 'checkbox';
  return type === 'range' && event.target.id !== 'slider' && /^(Arrow|Home|End)/.test(event.key);
}

document.addEventListener('keydown', (event) => {
  const key = kKeys.find(([name]) => name === event.key);
  if (!key || isTaken(event)) return;
  event.preventDefault();
  if (event.shiftKey && event.key.startsWith('Arrow')) step(event.key === 'ArrowLeft' ? -10 : 10); else key[3]();
});

const on = (id, type, action) => element(id).addEventListener(type, action);
on('slider', 'input', () => { play(false); choose(Number(element('slider').value)); });
on('play', 'click', () => play(!state.isPlaying));
on('tightest', 'click', goTightest);
on('closer', 'click', () => lookCloser());
on('way', 'click', () => fly((to) => to.showWay()));
on('whole', 'click', () => fly((to) => to.showAll()));
on('opacity', 'input', () => setOpacity(element('opacity').value));
on('ghosts', 'input', () => view?.showGhosts(element('ghosts').checked));
on('edges', 'input', () => view?.showEdges(element('edges').checked));
on('log', 'input', () => profile.setLogarithmic(element('log').checked));
on('save', 'click', savePicture);
on('copy', 'click', () => copyText(closestText(frames[state.frame])));
on('look', 'click', () => applyLook(document.documentElement.dataset.look !== 'dark'));
on('help-button', 'click', () => element('help').showModal());
darkLook.addEventListener('change', () => applyLook(darkLook.matches));
for (const id of ['cut-place', 'cut-flip']) on(id, 'input', cut);
on('cut-axis', 'input', () => element('cut-axis').value === 'gap' ? lookCloser() : cut());
// A button pressed by the pointer does not keep the focus, so that the space bar goes on playing.
document.addEventListener('click', (event) => { if (event.detail > 0) event.target.closest('button')?.blur(); });

element('keys').append(...kKeys.flatMap(([, shown, words]) => [make('dt', {}, make('kbd', {}, shown)), make('dd', {}, words)]));
if (!view) document.documentElement.classList.add('no-view');
for (const control of document.querySelectorAll('.for-view, .for-view *')) {
  if ('disabled' in control && !view) control.disabled = true;
}
drawLegend();
fillTables((i) => { play(false); choose(i); });
choose(0);
if (view) {
  setOpacity(kFirstOpacity);
  view.showWay();
  cut();
}

// For tests: tells what is shown, and what a redraw draws.
window.clearwayReport = {
  data, frames, view, profile, choose, picture, closestText,
  get frame() { return state.frame; },
  get partPosition() { return view.part.getWorldPosition(new THREE.Vector3()).toArray(); },
  get isPlaying() { return state.isPlaying; },
  get isFlying() { return Boolean(view.eye.flight); },
  get trianglesOf() { return { part: view.partBody.triangleCount, environment: view.wall.body.triangleCount }; },
  // Where a point of the scene is in the view, in CSS pixels.
  placeInView(point) {
    view.camera.updateMatrixWorld();
    const at = new THREE.Vector3(...point).project(view.camera);
    return [(at.x + 1) / 2 * view.container.clientWidth, (1 - at.y) / 2 * view.container.clientHeight];
  },
  // Chooses a frame, redraws, and tells the triangles and objects drawn. isAll: draws the environment again too.
  drawnFor(i, isAll) {
    choose(i);
    if (isAll) view.askRedrawOfAll();
    const info = view.renderer.info;
    info.autoReset = false;
    info.reset();
    view.redraw();
    info.autoReset = true;
    return { triangles: info.render.triangles, objects: info.render.calls };
  },
};
