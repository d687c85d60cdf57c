// ---- what stands still ----

const kMovingLayer = 0, kWallLayer = 1, kGhostLayer = 2;

// Pictures with depths of the surroundings and of the ghosts, which stand still while the part moves. Every redraw
// reuses them until the camera or the cut changes. Being pictures of the nearest surface, they can be laid over the
// part as see-through sheets, in the order of their depths.
class StillLayers {
  constructor() {
    this.wall = this.newTarget();
    this.ghosts = this.newTarget();
    // The surroundings with outlines, which a pass over the screen draws where their depth jumps.
    this.inked = new THREE.WebGLRenderTarget(1, 1, { type: THREE.HalfFloatType, depthBuffer: false });
    this.ink = { value: new THREE.Color() };
    this.inking = new THREE.Scene();
    this.inking.add(this.newInk());
    this.opacity = { value: 1 };
    this.sheets = [this.sheet(false), this.sheet(true)];
    this.isOld = true;
  }

  newTarget() {
    const target = new THREE.WebGLRenderTarget(1, 1, { samples: 4, type: THREE.HalfFloatType });
    target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    return target;
  }

  // A triangle over the whole screen. main: the body of its fragment shader, for the `place` from 0 to 1.
  screen(uniforms, declarations, main, options) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
    const screen = new THREE.Mesh(geometry, new THREE.ShaderMaterial({
      uniforms, depthWrite: false, ...options,
      vertexShader: 'varying vec2 place; void main() { place = 0.5 * position.xy + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `varying vec2 place; ${declarations} void main() { ${main} }`,
    }));
    screen.frustumCulled = false;
    return screen;
  }

  // The depth of a plane is linear on the screen, so that its second difference shows jumps alone. The pixel in front
  // of a jump is inked when the jump is more than a small share of the distance.
  newInk() {
    this.range = { value: new THREE.Vector2() };
    return this.screen(
      { wall: { value: this.wall.texture }, depths: { value: this.wall.depthTexture }, ink: this.ink, range: this.range },
      'uniform sampler2D wall; uniform highp sampler2D depths; uniform vec3 ink; uniform vec2 range;',
      `ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(depths, 0) - 1;
      #define depthAt(x, y) texelFetch(depths, clamp(at + ivec2(x, y), ivec2(0), last), 0).r
      float depth = depthAt(0, 0);
      float jump = max(depthAt(1, 0) + depthAt(-1, 0), depthAt(0, 1) + depthAt(0, -1)) - 2.0 * depth;
      float away = range.x * range.y / (range.y - depth * (range.y - range.x));
      float darkness = 0.75 * smoothstep(0.006, 0.015, jump * away / range.x);
      vec4 colour = texture2D(wall, place);
      gl_FragColor = vec4(mix(colour.rgb, ink * colour.a, darkness), colour.a);`,
      { depthTest: false, blending: THREE.NoBlending });
  }

  // Shows the nearer, or the farther, of the two pictures at each pixel.
  sheet(isNear) {
    const sheet = this.screen(
      {
        wall: { value: this.inked.texture }, wallDepths: { value: this.wall.depthTexture },
        ghosts: { value: this.ghosts.texture }, ghostDepths: { value: this.ghosts.depthTexture },
        opacity: this.opacity, isNear: { value: isNear },
      },
      'uniform sampler2D wall, ghosts; uniform highp sampler2D wallDepths, ghostDepths; uniform float opacity; uniform bool isNear;',
      `float wallDepth = texture2D(wallDepths, place).r, ghostDepth = texture2D(ghostDepths, place).r;
      bool isWall = (wallDepth <= ghostDepth) == isNear;
      vec4 colour = isWall ? texture2D(wall, place) : texture2D(ghosts, place);
      if (colour.a < 0.004) discard;
      gl_FragColor = vec4(colour.rgb / colour.a, colour.a * (isWall ? opacity : 1.0));
      gl_FragDepth = isWall ? wallDepth : ghostDepth + 2e-6;  // behind the part, where the part is at its start or goal
      #include <colorspace_fragment>`,
      { transparent: true });
    sheet.renderOrder = isNear ? 2 : 1;
    return sheet;
  }

  setSize(width, height) {
    for (const target of [this.wall, this.ghosts, this.inked]) target.setSize(width, height);
    this.isOld = true;
  }

  draw(renderer, scene, camera) {
    renderer.setClearAlpha(0);
    for (const [target, layer] of [[this.wall, kWallLayer], [this.ghosts, kGhostLayer]]) {
      camera.layers.set(layer);
      renderer.setRenderTarget(target);
      renderer.render(scene, camera);
    }
    this.range.value.set(camera.near, camera.far);
    camera.layers.set(kMovingLayer);
    renderer.setRenderTarget(this.inked);
    renderer.render(this.inking, camera);
    renderer.setRenderTarget(null);
    renderer.setClearAlpha(1);
    this.isOld = false;
  }
}

// The surroundings: faces, sharp edges, the cut, and one obstacle that may be pointed out.
class Wall {
  constructor(scene) {
    this.body = new Body(data.environment);
    const shared = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, side: THREE.DoubleSide };
    this.faces = new THREE.MeshLambertMaterial({ ...shared, flatShading: true });
    this.lines = new THREE.LineBasicMaterial();
    this.hiddenLines = new THREE.LineBasicMaterial({ depthTest: false, transparent: true, opacity: 0.22 });
    this.pointedLines = new THREE.LineBasicMaterial({ depthTest: false, transparent: true });
    this.pointedFaces = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, transparent: true, opacity: 0.55 });
    this.edges = this.body.edgesWith(this.lines);
    this.hiddenEdges = this.body.edgesWith(this.hiddenLines);  // shown where the surroundings are see-through
    this.pointed = [this.body.place(new THREE.Mesh(this.body.geometryOf(this.body.corners), this.pointedFaces)),
      this.body.place(new THREE.LineSegments(this.body.geometryOf(this.body.ends), this.pointedLines))];
    for (const object of [this.body.facesWith(this.faces), this.edges, this.hiddenEdges, ...this.pointed]) {
      object.layers.set(kWallLayer);
      scene.add(object);
    }
    this.plane = null;
    this.pointOut(-1);
  }

  get materials() { return [this.faces, this.lines, this.hiddenLines, this.pointedLines, this.pointedFaces]; }

  // Draws an obstacle in the colour that points things out; -1: none.
  pointOut(index) {
    const run = this.body.runs[index];
    for (const object of this.pointed) object.visible = Boolean(run) && !run.isHidden;
    if (!run) return;
    this.pointed[0].geometry.setDrawRange(run.corner, run.corners);
    this.pointed[1].geometry.setDrawRange(run.end, run.ends);
  }

  cut(axis, share, isFlipped) {
    this.plane = null;
    if (axis) {
      const i = 'xyz'.indexOf(axis);
      const place = data.environment.low[i] + share * data.environment.extent[i];
      this.plane = new THREE.Plane(new THREE.Vector3().setComponent(i, isFlipped ? 1 : -1), isFlipped ? -place : place);
    }
    for (const material of this.materials) material.clippingPlanes = this.plane ? [this.plane] : [];
  }

  // The lengths along a ray between which the cut leaves the surroundings.
  uncut(ray) {
    if (!this.plane) return [0, Infinity];
    const start = this.plane.distanceToPoint(ray.origin), rise = this.plane.normal.dot(ray.direction);
    if (rise === 0) return start >= 0 ? [0, Infinity] : [0, 0];
    return rise > 0 ? [Math.max(0, -start / rise), Infinity] : [0, -start / rise];
  }
}
