// ---- what stands still ----

const kMovingLayer = 0, kWallLayer = 1, kGhostLayer = 2;

// Pictures with depths of the surroundings and of the ghosts, which stand still while the part moves. At each pixel
// one of them is in front of the other: a sheet shows the nearer ones, another the farther ones. Every redraw lays the
// sheets over the part, see-through, until the camera or the cut changes.
class StillLayers {
  constructor(areSmooth) {
    const drawn = { samples: areSmooth ? 4 : 0, type: THREE.HalfFloatType };
    const stored = { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter };
    this.wall = this.newTarget(drawn);
    this.ghosts = this.newTarget(drawn);
    this.pictures = [this.newTarget(stored), this.newTarget(stored)];  // the farther one, the nearer one
    this.opacity = { value: 1 };
    this.ink = { value: new THREE.Color() };
    this.range = { value: new THREE.Vector2() };
    this.mixes = [this.newMix(false), this.newMix(true)];
    this.sheets = this.pictures.map((picture, i) => this.newSheet(picture, i));
    this.isOld = true;
  }

  newTarget(options) {
    const target = new THREE.WebGLRenderTarget(1, 1, options);
    target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    return target;
  }

  // A triangle over the whole screen. main: the body of its fragment shader.
  newScreen(uniforms, declarations, main, options) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
    const screen = new THREE.Mesh(geometry, new THREE.ShaderMaterial({
      uniforms, ...options,
      vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `#define fetch(picture) texelFetch(picture, ivec2(gl_FragCoord.xy), 0)
        ${declarations}
        void main() { ${main} }`,
    }));
    screen.frustumCulled = false;
    return screen;
  }

  // Picks the nearer or the farther one at each pixel, and inks the outlines of the surroundings. The depth of a plane
  // is linear on the screen, so that its second difference shows jumps alone. The pixel in front of a jump is inked
  // when the jump is more than a small share of the distance.
  newMix(isNear) {
    const scene = new THREE.Scene();
    scene.add(this.newScreen(
      {
        wall: { value: this.wall.texture }, wallDepths: { value: this.wall.depthTexture },
        ghosts: { value: this.ghosts.texture }, ghostDepths: { value: this.ghosts.depthTexture },
        opacity: this.opacity, inkColour: this.ink, range: this.range, isNear: { value: isNear },
      },
      `uniform sampler2D wall, ghosts; uniform highp sampler2D wallDepths, ghostDepths;
      uniform float opacity; uniform vec3 inkColour; uniform vec2 range; uniform bool isNear;
      float depthBeside(highp sampler2D depths, int x, int y) {
        return texelFetch(depths, clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), textureSize(depths, 0) - 1), 0).r;
      }
      float darkness(highp sampler2D depths, float depth) {
        float jump = max(depthBeside(depths, 1, 0) + depthBeside(depths, -1, 0), depthBeside(depths, 0, 1) + depthBeside(depths, 0, -1));
        float away = range.x * range.y / (range.y - depth * (range.y - range.x));
        return 0.75 * smoothstep(0.006, 0.015, (jump - 2.0 * depth) * away / range.x);
      }`,
      `float wallDepth = fetch(wallDepths).r;
      float ghostDepth = fetch(ghostDepths).r + 2e-6;  // behind the part, where the part is at its start or goal
      bool isWall = (wallDepth <= ghostDepth) == isNear;
      vec4 colour = isWall ? fetch(wall) : fetch(ghosts);
      gl_FragColor = vec4(0.0);
      gl_FragDepth = 1.0;
      if (colour.a > 0.004) {
        colour.rgb /= colour.a;
        if (isWall) {
          colour = mix(colour, vec4(inkColour, 1.0), darkness(wallDepths, wallDepth));
          // Faces were drawn with half the alpha of lines, so that lines can stay stronger where faces are see-through.
          colour.a = colour.a < 0.5 ? 2.0 * colour.a * opacity : mix(opacity, sqrt(opacity), 2.0 * colour.a - 1.0);
        } else {
          colour.a = mix(colour.a, 0.7, darkness(ghostDepths, ghostDepth));
        }
        gl_FragColor = sRGBTransferOETF(colour);
        gl_FragDepth = min(1.0, isWall ? wallDepth : ghostDepth);
      }`,
      { depthFunc: THREE.AlwaysDepth, blending: THREE.NoBlending }));
    return scene;
  }

  newSheet(picture, i) {
    const sheet = this.newScreen(
      { picture: { value: picture.texture }, depths: { value: picture.depthTexture } },
      'uniform sampler2D picture; uniform highp sampler2D depths;',
      `gl_FragColor = fetch(picture);
      if (gl_FragColor.a == 0.0) discard;
      gl_FragDepth = fetch(depths).r;`,
      { transparent: true, depthWrite: false });
    sheet.renderOrder = 1 + i;
    return sheet;
  }

  setSize(width, height) {
    for (const target of [this.wall, this.ghosts, ...this.pictures]) target.setSize(width, height);
    this.isOld = true;
  }

  draw(renderer, scene, camera) {
    renderer.setClearAlpha(0);
    const drawTo = (target, drawn, layer) => {
      camera.layers.set(layer);
      renderer.setRenderTarget(target);
      renderer.render(drawn, camera);
    };
    drawTo(this.wall, scene, kWallLayer);
    drawTo(this.ghosts, scene, kGhostLayer);
    this.range.value.set(camera.near, camera.far);
    this.mixes.forEach((mix, i) => drawTo(this.pictures[i], mix, kMovingLayer));
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
    const half = { transparent: true, forceSinglePass: true, opacity: 0.5, premultipliedAlpha: true, blending: THREE.NoBlending };  // see newMix
    this.faces = new THREE.MeshLambertMaterial({ ...shared, ...half, flatShading: true });
    this.faces.onBeforeCompile = paintSections;
    this.lines = new THREE.LineBasicMaterial();
    this.hiddenLines = new THREE.LineBasicMaterial({ depthTest: false, transparent: true, opacity: 0.22 });
    this.pointedLines = new THREE.LineBasicMaterial({ depthTest: false, transparent: true });
    this.pointedFaces = new THREE.MeshBasicMaterial({ depthTest: false, side: THREE.DoubleSide, transparent: true, opacity: 0.3 });
    this.edges = this.body.edgesWith(this.lines);
    this.hiddenEdges = this.body.edgesWith(this.hiddenLines);  // shown where the surroundings are see-through
    this.pointed = [this.body.place(new THREE.Mesh(this.body.geometryOf(this.body.corners), this.pointedFaces)),
      this.body.place(new THREE.LineSegments(this.body.geometryOf(this.body.ends), this.pointedLines))];
    [this.body.facesWith(this.faces), this.edges, this.hiddenEdges, ...this.pointed].forEach((object, i) => {
      object.layers.set(kWallLayer);
      object.renderOrder = i;
      scene.add(object);
    });
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

  planeAcross(axis, share, isFlipped) {
    const i = 'xyz'.indexOf(axis);
    const place = data.environment.low[i] + share * data.environment.extent[i];
    return new THREE.Plane(new THREE.Vector3().setComponent(i, isFlipped ? 1 : -1), isFlipped ? -place : place);
  }

  // Leaves what is on the positive side of a plane, or everything for null.
  cut(plane) {
    this.plane = plane;
    for (const material of this.materials) material.clippingPlanes = plane ? [plane] : [];
  }

  // The lengths along a ray between which the cut leaves the surroundings.
  uncut(ray) {
    if (!this.plane) return [0, Infinity];
    const start = this.plane.distanceToPoint(ray.origin), rise = this.plane.normal.dot(ray.direction);
    if (rise === 0) return start >= 0 ? [0, Infinity] : [0, 0];
    return rise > 0 ? [Math.max(0, -start / rise), Infinity] : [0, -start / rise];
  }
}
