// ---- the view ----

const kScaleWidth = 120;  // pixels
const kUsualDirection = [0.62, -1, 0.62];
const kGapsInView = 20;  // gaps that a close look shows from its middle to its border
const kLeastRadius = Math.max(...data.environment.extent, ...data.part.extent) / 300;  // of a close look: places of vertices are rounded
const kPartRadius = new THREE.Vector3(...data.part.extent).length() / 2;

// Without a graphics card, smooth edges cost most of the time of a redraw. They are left out where the part moves, and
// in large surroundings.
const kMostSmooth = 150000;  // triangles
function isDrawnBySoftware(gl) {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return /swiftshader|llvmpipe|software/i.test(name);
}

const colourOf = (bytes) => new THREE.Color().setRGB(...bytes.map((value) => value / 255), THREE.SRGBColorSpace);

class View {
  // gl: a WebGL context made for a trial.
  constructor(container, gl) {
    this.container = container;
    const isSlow = isDrawnBySoftware(gl);
    this.renderer = new THREE.WebGLRenderer({ antialias: !isSlow });
    this.renderer.localClippingEnabled = true;
    container.prepend(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.eye = new Eye(this.renderer.domElement, () => this.moved());
    this.camera = this.eye.camera;
    this.addLights();
    this.addPart();
    this.wall = new Wall(this.scene);
    this.still = new StillLayers(!isSlow || this.wall.body.triangleCount < kMostSmooth);
    this.scene.add(...this.still.sheets);
    this.addClosestPair();
    this.labels = ['start', 'goal'].map((text) => container.appendChild(make('span', { className: 'label', textContent: text })));
    new ResizeObserver(() => this.fit()).observe(container);
    this.fit();
    this.applyLook();
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

  // The part, its ghosts at start and goal, and the line of its way.
  addPart() {
    this.partBody = new Body(data.part);
    this.areGhostsShown = true;
    this.hatching = { value: 0 };  // its period in pixels; 0: none
    const shared = { flatShading: true, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    this.partMaterial = new THREE.MeshLambertMaterial(shared);
    this.partMaterial.onBeforeCompile = (shader) => {
      shader.uniforms.hatching = this.hatching;
      paintSections(shader);
      shader.fragmentShader = 'uniform float hatching;\n' + shader.fragmentShader.replace('#include <dithering_fragment>',
        `if (NUM_CLIPPING_PLANES == 0 || gl_FrontFacing)  // outlines where it is round
          gl_FragColor.rgb *= 0.4 + 0.6 * smoothstep(0.0, 0.25, abs(dot(normal, normalize(vViewPosition))));
        if (hatching > 0.0 && fract((gl_FragCoord.x + gl_FragCoord.y) / hatching) < 0.3) gl_FragColor.rgb = vec3(0.0);`);
    };
    this.partLines = new THREE.LineBasicMaterial();
    this.part = new THREE.Group();
    this.partEdges = this.partBody.edgesWith(this.partLines);
    this.part.add(this.partBody.facesWith(this.partMaterial), this.partEdges);
    // A ghost replaces what is behind in its layer, so that only its nearest surface is seen.
    const ghost = { transparent: true, premultipliedAlpha: true, blending: THREE.NoBlending };
    this.ghostMaterial = new THREE.MeshLambertMaterial({ ...shared, ...ghost, opacity: 0.33 });
    this.ghostLines = new THREE.LineBasicMaterial({ ...ghost, opacity: 0.6 });
    this.ghosts = [frames[0], frames[frames.length - 1]].map((frame) => {
      const group = new THREE.Group();
      group.add(this.partBody.facesWith(this.ghostMaterial), this.partBody.edgesWith(this.ghostLines));
      this.pose(group, frame);
      return group;
    });
    const way = new THREE.BufferGeometry();
    way.setAttribute('position', new THREE.Float32BufferAttribute(frames.flatMap((frame) => frame.position), 3));
    this.wayMaterial = new THREE.LineBasicMaterial();
    const still = [...this.ghosts, new THREE.Line(way, this.wayMaterial)];
    for (const object of still) object.traverse((child) => child.layers.set(kGhostLayer));
    this.scene.add(this.part, ...still);
  }

  // Drawn on top of everything, because the pair lies hidden between part and environment.
  addClosestPair() {
    const over = { depthTest: false, transparent: true };
    this.pairLine = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial(over));
    this.pairLine.geometry.setAttribute('position', new THREE.Float32BufferAttribute(new Float32Array(6), 3));
    this.pairEnds = new THREE.Points(this.pairLine.geometry, new THREE.PointsMaterial({ ...over, size: 8, sizeAttenuation: false }));
    for (const object of [this.pairLine, this.pairEnds]) {
      object.frustumCulled = false;
      object.renderOrder = 3;
      this.scene.add(object);
    }
  }

  applyLook() {
    const paint = (material, name) => material.color.set(styleColour(name));
    this.renderer.setClearColor(styleColour('view'));
    paint(this.wall.faces, 'wall');
    for (const material of [this.wall.lines, this.wall.hiddenLines]) paint(material, 'edge');
    paint(this.partLines, 'part-edge');
    for (const material of [this.ghostMaterial, this.ghostLines]) paint(material, 'ghost');
    for (const material of [this.wall.pointedFaces, this.wall.pointedLines]) paint(material, 'accent');
    for (const material of [this.pairLine.material, this.pairEnds.material]) paint(material, 'mark');
    paint(this.wayMaterial, 'way');
    this.still.ink.value.set(styleColour('edge'));
    this.askRedrawOfAll();
  }

  // ---- the camera ----

  moved() {
    // A ghost near the camera would hide what is looked at.
    for (const ghost of this.ghosts) ghost.visible = this.areGhostsShown && this.eye.distance > 2.2 * kPartRadius;
    this.askRedrawOfAll();
  }

  cornersOf(mesh) {
    return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new THREE.Vector3(
      ...mesh.low.map((low, axis) => low + (i >> axis & 1) * mesh.extent[axis])));
  }

  wayPoints() {
    const corners = this.cornersOf(data.part);
    return frames.flatMap((frame) => {
      const turn = new THREE.Quaternion(...frame.rotation), at = vector(frame.position);
      return corners.map((corner) => corner.clone().applyQuaternion(turn).add(at));
    });
  }

  see(points, direction) { this.eye.flyToSee(points, direction, 1 - kScaleWidth / this.container.clientWidth); }
  showWay() { this.see(this.wayPoints(), data.view.direction); }
  showAll() { this.see([...this.cornersOf(data.environment), ...this.wayPoints()], kUsualDirection); }

  // Puts the closest pair in the middle, at a distance that shows its gap. The direction is turned until it is
  // perpendicular to the gap.
  lookCloser(frame, direction) {
    if (!frame.pair) return;
    const [from, to] = frame.pair.map(vector), gap = to.clone().sub(from), middle = from.lerp(to, 0.5);
    const back = [direction, vector(kUsualDirection), this.camera.up]
      .map((tried) => tried.clone().normalize().projectOnPlane(gap)).find((tried) => tried.length() > 0.1).normalize();
    const radius = Math.min(0.3 * kPartRadius, kGapsInView * frame.distance || Infinity);
    this.gapPlane = new THREE.Plane().setFromNormalAndCoplanarPoint(back.clone().negate(), middle);
    this.eye.flyToBall(middle, Math.max(radius, 2 * frame.distance, kLeastRadius), back);
  }

  // ---- what is shown ----

  // axis: x, y, z, none, or gap, which cuts the part too, where the view last looked closer.
  cut(axis, share, isFlipped) {
    const plane = axis === 'gap' ? this.gapPlane : axis && this.wall.planeAcross(axis, share, isFlipped);
    const isSection = axis === 'gap' && Boolean(plane);
    this.wall.cut(plane || null);
    this.partMaterial.clippingPlanes = isSection ? [plane] : [];
    for (const lines of [this.partLines, this.wall.lines, this.wall.hiddenLines]) lines.visible = !isSection;  // they lie behind it
    this.askRedrawOfAll();
  }

  seeThrough(opacity) {
    this.still.opacity.value = opacity;
    this.wall.hiddenEdges.visible = opacity < 1 && this.wall.edges.visible;
    this.askRedrawOfAll();
  }

  showEdges(areShown) {
    this.wall.edges.visible = this.partEdges.visible = areShown;
    this.seeThrough(this.still.opacity.value);
  }

  showGhosts(areShown) {
    this.areGhostsShown = areShown;
    this.moved();
  }

  showObstacles() {
    this.wall.body.drawVisible();
    this.askRedrawOfAll();
  }

  pointOut(index) {
    this.wall.pointOut(index);
    this.askRedrawOfAll();
  }

  pose(object, frame) {
    object.position.fromArray(frame.position);
    object.quaternion.fromArray(frame.rotation);
  }

  show(frame) {
    this.pose(this.part, frame);
    this.partMaterial.color.copy(colourOf(frameColour(frame)));
    this.hatching.value = frame.trouble ? 14 * this.renderer.getPixelRatio() : 0;
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

  // Finds the mesh at a place of the view, in CSS pixels: { name, object }; object: index of the obstacle, if any.
  at(x, y) {
    const ray = new THREE.Ray(this.camera.position.clone(), this.pointAt(x, y).sub(this.camera.position).normalize());
    const wall = this.still.opacity.value > 0 &&
      this.wall.body.hit(ray.origin.toArray(), ray.direction.toArray(), ...this.wall.uncut(ray));
    const inPart = ray.clone().applyMatrix4(this.part.matrixWorld.clone().invert());
    const [from, to] = this.partMaterial.clippingPlanes?.length ? this.wall.uncut(ray) : [0, Infinity];
    const part = this.partBody.hit(inPart.origin.toArray(), inPart.direction.toArray(), from, wall ? wall.along : to);
    if (part) return { name: `part: ${data.part.objects[part.object].name}` };
    return wall ? { name: objects[wall.object].name, object: wall.object } : null;
  }

  pointAt(x, y) {
    const { clientWidth: width, clientHeight: height } = this.container;
    return new THREE.Vector3(2 * x / width - 1, 1 - 2 * y / height, 0.5).unproject(this.camera);
  }

  placeLabels() {
    const { clientWidth: width, clientHeight: height } = this.container;
    this.labels.forEach((label, i) => {
      const at = this.ghosts[i].position.clone().project(this.camera);
      label.hidden = !this.ghosts[i].visible || Math.abs(at.x) > 0.97 || Math.abs(at.y) > 0.95 || at.z > 1;
      label.style.transform = `translate(${(at.x + 1) / 2 * width}px, ${(1 - at.y) / 2 * height}px) translate(-50%, ${i ? 25 : -125}%)`;
    });
  }

  // ---- drawing ----

  fit() {
    const { clientWidth: width, clientHeight: height } = this.container;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height);
    this.eye.setAspect(width / height);
    const pixels = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    this.still.setSize(pixels.x, pixels.y);
    this.askRedraw();
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
    if (this.still.isOld) this.still.draw(this.renderer, this.scene, this.camera);
    this.renderer.render(this.scene, this.camera);
    this.placeLabels();
  }
}
