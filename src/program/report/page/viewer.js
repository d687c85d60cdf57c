// The report page: a 3D view, a slider along the path, the clearance profile, figures and tables.
// Coordinates are those of the environment minus data.origin, so that floats represent them well.
import * as THREE from 'three';
import { OrbitControls } from 'orbit-controls';

const data = JSON.parse(document.getElementById('data').textContent);
const element = (id) => document.getElementById(id);
const frames = data.frames;
const state = { frame: 0, isPlaying: false };

const digits = (value) => Number(value.toPrecision(5)).toString();

// ---- the view ----

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

// A triangle is three 32-bit numbers.
const trianglesIn = (mesh) => bytesOf(mesh.triangles).byteLength / 12;

// Positions are 16-bit shares of the mesh's box; the matrix of the object scales them back.
function objectOf(mesh, material) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Uint16Array(bytesOf(mesh.positions)), 3, true));
  geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytesOf(mesh.triangles)), 1));
  const object = new THREE.Mesh(geometry, material);
  object.position.fromArray(mesh.low);
  object.scale.fromArray(mesh.extent);
  object.frustumCulled = false;
  return object;
}

function colourOf(clearance) {
  const share = clearance === null ? 1 : Math.min(1, Math.max(0, clearance / data.scaleMost));
  const place = share * (data.scale.length - 1);
  const below = Math.min(Math.floor(place), data.scale.length - 2);
  const [a, b] = [data.scale[below], data.scale[below + 1]];
  return new THREE.Color().setRGB(...a.map((value, i) => (value + (place - below) * (b[i] - value)) / 255), THREE.SRGBColorSpace);
}

// Keeps the environment, which stands still while the part moves, as a picture with depths. Every redraw reuses the
// picture until the camera or the cut changes.
class StillLayer {
  constructor() {
    this.target = new THREE.WebGLRenderTarget(1, 1, { samples: 4, type: THREE.HalfFloatType });
    this.target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    const material = new THREE.ShaderMaterial({
      uniforms: { colours: { value: this.target.texture }, depths: { value: this.target.depthTexture } },
      vertexShader: 'varying vec2 place; void main() { place = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `varying vec2 place; uniform sampler2D colours; uniform highp sampler2D depths;
        void main() {
          gl_FragColor = texture2D(colours, place);
          gl_FragDepth = texture2D(depths, place).r;
          #include <colorspace_fragment>
        }`,
      depthFunc: THREE.AlwaysDepth,
    });
    this.object = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = -1;
    this.isOld = true;
  }
}

// Without a graphics card, smooth edges cost most of the time of a redraw.
function isDrawnBySoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return false;
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  const lose = gl.getExtension('WEBGL_lose_context');
  if (lose) lose.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

const kMovingLayer = 0, kStillLayer = 1;

class View {
  constructor(container) {
    this.container = container;
    this.renderer = new THREE.WebGLRenderer({ antialias: !isDrawnBySoftware() });
    this.renderer.localClippingEnabled = true;
    this.renderer.setClearColor(0xf4f5f7);
    container.prepend(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 1, 1000);
    this.camera.up.set(0, 0, 1);
    this.addLights();
    this.addMeshes();
    this.addClosestPair();
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.askRedrawOfAll());
    new ResizeObserver(() => this.fit()).observe(container);
    this.fit();
    this.showAll();
  }

  addLights() {
    const sky = new THREE.HemisphereLight(0xffffff, 0x8a8580, 1.5);
    sky.layers.enableAll();
    this.scene.add(sky);
    const key = new THREE.DirectionalLight(0xffffff, 2.2);
    key.position.set(-0.9, 0.8, 0.6);
    key.layers.enableAll();
    this.camera.add(key);
    this.scene.add(this.camera);
  }

  addMeshes() {
    this.wallMaterial = new THREE.MeshLambertMaterial({ color: 0xd0d2d6, flatShading: true, side: THREE.DoubleSide });
    this.partMaterial = new THREE.MeshLambertMaterial({ flatShading: true, side: THREE.DoubleSide });
    this.wall = objectOf(data.environment, this.wallMaterial);
    this.wall.layers.set(kStillLayer);
    this.still = new StillLayer();
    this.part = new THREE.Group();
    this.part.add(objectOf(data.part, this.partMaterial));
    const line = new THREE.BufferGeometry();
    line.setAttribute('position', new THREE.Float32BufferAttribute(frames.flatMap((frame) => frame.position), 3));
    this.scene.add(this.wall, this.still.object, this.part, new THREE.Line(line, new THREE.LineBasicMaterial({ color: 0x333a55 })));
  }

  // Drawn on top of everything, because the pair lies hidden between part and environment.
  addClosestPair() {
    const over = { color: 0xd00030, depthTest: false, transparent: true };
    this.pairLine = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial(over));
    this.pairLine.geometry.setAttribute('position', new THREE.Float32BufferAttribute(new Float32Array(6), 3));
    this.pairEnds = new THREE.Points(this.pairLine.geometry, new THREE.PointsMaterial({ ...over, size: 8, sizeAttenuation: false }));
    for (const object of [this.pairLine, this.pairEnds]) {
      object.frustumCulled = false;
      object.renderOrder = 1;
      this.scene.add(object);
    }
  }

  lookAt(centre, radius, direction) {
    const distance = radius / Math.sin(this.camera.fov * Math.PI / 360) / Math.min(1, this.camera.aspect);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(direction.normalize(), distance);
    this.camera.near = Math.max(distance * 1e-3, data.radius * 1e-4);
    this.camera.far = distance + 20 * data.radius;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.askRedrawOfAll();
  }

  showAll() { this.lookAt(new THREE.Vector3(...data.middle), 0.72 * data.radius, new THREE.Vector3(0.62, -1, 0.62)); }

  // Puts the closest pair in the middle, at a distance that shows its surroundings.
  lookCloser() {
    const pair = frames[state.frame].pair;
    if (!pair) return;
    const direction = this.camera.position.clone().sub(this.controls.target);
    const middle = new THREE.Vector3(...pair[0]).add(new THREE.Vector3(...pair[1])).multiplyScalar(0.5);
    this.lookAt(middle, Math.max(0.04 * data.radius, 2 * (frames[state.frame].distance || 0)), direction);
  }

  cut(axis, share, isFlipped) {
    const planes = [];
    if (axis) {
      const i = 'xyz'.indexOf(axis);
      const place = data.environment.low[i] + share * data.environment.extent[i];
      const normal = new THREE.Vector3().setComponent(i, isFlipped ? 1 : -1);
      planes.push(new THREE.Plane(normal, isFlipped ? -place : place));
    }
    this.wallMaterial.clippingPlanes = planes;
    this.askRedrawOfAll();
  }

  show(frame) {
    this.part.position.fromArray(frame.position);
    this.part.quaternion.fromArray(frame.rotation);
    this.partMaterial.color.copy(colourOf(frame.clearance));
    const hasPair = Boolean(frame.pair);
    this.pairLine.visible = this.pairEnds.visible = hasPair;
    if (hasPair) {
      const positions = this.pairLine.geometry.attributes.position;
      positions.array.set(frame.pair[0], 0);
      positions.array.set(frame.pair[1], 3);
      positions.needsUpdate = true;
    }
    this.askRedraw();
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.container;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    const pixels = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    this.still.target.setSize(pixels.x, pixels.y);
    this.askRedrawOfAll();
  }

  askRedrawOfAll() {
    this.still.isOld = true;
    this.askRedraw();
  }

  askRedraw() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => this.redraw());
  }

  redraw() {
    this.isAsked = false;
    if (this.still.isOld) {
      this.camera.layers.set(kStillLayer);
      this.renderer.setRenderTarget(this.still.target);
      this.renderer.render(this.scene, this.camera);
      this.renderer.setRenderTarget(null);
      this.camera.layers.set(kMovingLayer);
      this.still.isOld = false;
    }
    this.renderer.render(this.scene, this.camera);
  }
}

// ---- the clearance profile ----

class Profile {
  constructor(canvas, choose) {
    this.canvas = canvas;
    const chooseAt = (event) => {
      const box = canvas.getBoundingClientRect();
      choose(this.frameAt(event.clientX - box.left));
    };
    canvas.addEventListener('pointerdown', (event) => { canvas.setPointerCapture(event.pointerId); chooseAt(event); });
    canvas.addEventListener('pointermove', (event) => { if (event.buttons) chooseAt(event); });
    new ResizeObserver(() => this.fit()).observe(canvas);
    this.fit();
  }

  fit() {
    const ratio = window.devicePixelRatio;
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    this.canvas.width = this.width * ratio;
    this.canvas.height = this.height * ratio;
    this.plot = { left: 56, right: this.width - 10, top: 18, bottom: this.height - 20 };
    this.still = document.createElement('canvas');
    this.still.width = this.canvas.width;
    this.still.height = this.canvas.height;
    const context = this.still.getContext('2d');
    context.scale(ratio, ratio);
    this.drawStill(context);
    this.show(state.frame);
  }

  x(share) { return this.plot.left + share * (this.plot.right - this.plot.left); }
  y(clearance) {
    const share = Math.min(1, Math.max(0, (clearance === null ? Infinity : clearance) / data.profileMost));
    return this.plot.bottom - share * (this.plot.bottom - this.plot.top);
  }
  frameAt(x) {
    const share = (x - this.plot.left) / (this.plot.right - this.plot.left);
    let best = 0;
    frames.forEach((frame, i) => { if (Math.abs(frame.share - share) < Math.abs(frames[best].share - share)) best = i; });
    return best;
  }

  drawStill(context) {
    const { left, right, top, bottom } = this.plot;
    context.font = '11px system-ui, sans-serif';
    context.fillStyle = '#555';
    context.strokeStyle = '#ddd';
    context.textAlign = 'right';
    for (let i = 0; i <= 4; ++i) {
      const y = this.y(data.profileMost * i / 4);
      context.beginPath(); context.moveTo(left, y); context.lineTo(right, y); context.stroke();
      context.fillText(digits(data.profileMost * i / 4), left - 6, y + 4);
    }
    context.textAlign = 'left';
    context.fillText('clearance' + (data.certified.length ? '; certified between poses: shaded' : ''), left, 11);
    context.textAlign = 'center';
    for (const share of [0, 0.25, 0.5, 0.75, 1]) context.fillText(share, this.x(share), bottom + 14);
    this.drawCertified(context);
    context.lineWidth = 2;
    for (let i = 1; i < frames.length; ++i) {
      context.strokeStyle = '#' + colourOf(Math.min(frames[i - 1].clearance ?? Infinity, frames[i].clearance ?? Infinity)).getHexString();
      context.beginPath();
      context.moveTo(this.x(frames[i - 1].share), this.y(frames[i - 1].clearance));
      context.lineTo(this.x(frames[i].share), this.y(frames[i].clearance));
      context.stroke();
    }
  }

  drawCertified(context) {
    const count = data.certified.length;
    context.fillStyle = 'rgba(40, 90, 160, 0.13)';
    data.certified.forEach((clearance, i) => {
      if (!(clearance > 0)) return;
      const y = this.y(clearance);
      context.fillRect(this.x(i / count), y, this.x((i + 1) / count) - this.x(i / count) + 0.3, this.plot.bottom - y);
    });
  }

  show(i) {
    const context = this.canvas.getContext('2d');
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.still, 0, 0);
    context.scale(window.devicePixelRatio, window.devicePixelRatio);
    const x = this.x(frames[i].share);
    context.strokeStyle = '#222';
    context.beginPath(); context.moveTo(x, this.plot.top - 4); context.lineTo(x, this.plot.bottom); context.stroke();
    context.fillStyle = '#d00030';
    context.beginPath(); context.arc(x, this.y(frames[i].clearance), 4, 0, 7); context.fill();
  }
}

// ---- texts ----

function drawScale(canvas) {
  const ratio = window.devicePixelRatio, width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext('2d');
  context.scale(ratio, ratio);
  context.fillStyle = 'rgba(255, 255, 255, 0.82)';
  context.fillRect(0, 0, width, height);
  context.font = '11px system-ui, sans-serif';
  const top = 24, bottom = height - 10;
  for (let y = top; y < bottom; ++y) {
    context.fillStyle = '#' + colourOf(data.scaleMost * (bottom - y) / (bottom - top)).getHexString();
    context.fillRect(8, y, 14, 1.5);
  }
  context.fillStyle = '#333';
  context.fillText('clearance', 8, 14);
  for (let i = 0; i <= 4; ++i) context.fillText(digits(data.scaleMost * i / 4), 27, bottom + (top - bottom) * i / 4 + 4);
}

function tableOf(table) {
  const made = document.createElement('table');
  if (!table.header.length) made.className = 'labels';
  const addRow = (cells, tag) => {
    const row = made.insertRow();
    for (const text of cells) {
      const cell = document.createElement(tag);
      cell.textContent = text;
      if (tag === 'td' && table.header.length && /^-?[\d.]+(e[-+]?\d+)?$/.test(text)) cell.className = 'number';
      row.append(cell);
    }
    return row;
  };
  if (table.header.length) addRow(table.header, 'th');
  table.rows.forEach((cells, i) => {
    const row = addRow(cells, 'td');
    if (!table.frames) return;
    row.className = 'jump';
    row.addEventListener('click', () => choose(table.frames[i]));
  });
  return made;
}

function fillTables() {
  for (const table of data.tables) {
    const title = document.createElement('h2');
    title.textContent = table.title;
    element('tables').append(title, tableOf(table));
  }
  element('verdict').textContent = data.verdict;
  element('note').textContent = data.note;
}

function showReadout(frame) {
  const readout = element('readout');
  readout.replaceChildren();
  const big = document.createElement('b');
  big.textContent = frame.isFree ? 'nothing to keep clear of' :
    'clearance ' + (frame.clearance === null ? 'out of reach' : digits(frame.clearance));
  readout.append(big, document.createElement('br'), `at ${digits(100 * frame.share)} % of the way`);
  if (frame.between) readout.append(document.createElement('br'), `${frame.between[0]} to ${frame.between[1]}`);
}

// ---- all together ----

let view = null;
try {
  view = new View(element('view'));
} catch (error) {
  element('failure').style.display = 'flex';
}
const slider = element('slider');
slider.max = frames.length - 1;
const profile = new Profile(element('profile'), (i) => choose(i));

function choose(i) {
  state.frame = Math.min(frames.length - 1, Math.max(0, Math.round(i)));
  slider.value = state.frame;
  const frame = frames[state.frame];
  if (view) view.show(frame);
  profile.show(state.frame);
  showReadout(frame);
}

// Plays the whole path in 12 seconds, and starts again after its end.
function play(isPlaying) {
  state.isPlaying = isPlaying;
  element('play').textContent = isPlaying ? 'Pause' : 'Play';
  if (!isPlaying) return;
  let place = state.frame >= frames.length - 1 ? 0 : frames[state.frame].share;
  let last = performance.now();
  const step = (now) => {
    if (!state.isPlaying) return;
    place += (now - last) / 12000;
    last = now;
    let i = state.frame >= frames.length - 1 ? 0 : state.frame;
    while (i < frames.length - 1 && frames[i].share < place) ++i;
    choose(i);
    if (i >= frames.length - 1) play(false); else requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function cut() {
  const axis = element('cut-axis').value;
  element('cut-place').disabled = !axis;
  if (view) view.cut(axis, element('cut-place').value / 1000, element('cut-flip').checked);
}

slider.addEventListener('input', () => { play(false); choose(Number(slider.value)); });
element('play').addEventListener('click', () => play(!state.isPlaying));
element('tightest').addEventListener('click', () => { play(false); choose(data.tightest); });
element('closer').addEventListener('click', () => { if (view) view.lookCloser(); });
element('whole').addEventListener('click', () => { if (view) view.showAll(); });
for (const id of ['cut-axis', 'cut-place', 'cut-flip']) element(id).addEventListener('input', cut);
drawScale(element('scale'));
fillTables();
choose(0);

// For tests: tells what is shown, and what a redraw draws.
window.clearwayReport = {
  frames,
  get frame() { return state.frame; },
  get partPosition() { return view.part.getWorldPosition(new THREE.Vector3()).toArray(); },
  get isPlaying() { return state.isPlaying; },
  choose,
  trianglesOf: { part: trianglesIn(data.part), environment: trianglesIn(data.environment) },
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
