// ---- the camera ----

const kFlightSeconds = 0.7;
const vector = (values) => new THREE.Vector3(...values);

// A camera that looks at a centre. The pointer moves it, and it flies to new places.
class Eye {
  // onMove is called whenever the camera has moved.
  constructor(canvas, onMove) {
    this.camera = new THREE.PerspectiveCamera(30, 1, 1, 1000);
    this.camera.up.set(0, 0, 1);
    this.onMove = onMove;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.moved());
    for (const type of ['pointerdown', 'wheel']) {
      canvas.addEventListener(type, () => { this.flight = null; }, { passive: true });
    }
  }

  get centre() { return this.controls.target; }
  get offset() { return this.camera.position.clone().sub(this.centre); }
  get distance() { return this.offset.length(); }
  get slope() { return Math.tan(this.camera.fov * Math.PI / 360); }  // of the upper border of the view

  setAspect(aspect) {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  moved() {
    this.camera.near = Math.max(this.distance * 1e-3, data.radius * 1e-4);
    this.camera.far = this.distance + 20 * data.radius;
    this.camera.updateProjectionMatrix();
    this.onMove();
  }

  // Moves the camera to centre + offset, and looks at the centre.
  go(centre, offset) {
    this.centre.copy(centre);
    this.camera.position.copy(centre).add(offset);
    this.controls.update();
    this.moved();
  }

  // Turns the camera around the upright axis, and changes its distance by a factor.
  turn(angle, factor) {
    this.flight = null;
    this.go(this.centre.clone(), this.offset.applyAxisAngle(this.camera.up, angle).multiplyScalar(factor));
  }

  fly(centre, offset) {
    this.flight = null;
    if (lessMotion.matches || !this.isPlaced) {
      this.isPlaced = true;
      this.go(centre, offset);
      return;
    }
    const fromCentre = this.centre.clone(), fromOffset = this.offset;
    const turn = new THREE.Quaternion().setFromUnitVectors(fromOffset.clone().normalize(), offset.clone().normalize());
    const flight = this.flight = { start: performance.now() };
    const step = (now) => {
      if (this.flight !== flight) return;
      const time = Math.min(1, Math.max(0, (now - flight.start) / (1000 * kFlightSeconds)));
      if (time === 1) {
        this.flight = null;
        this.go(centre, offset);
        return;
      }
      const share = time * time * (3 - 2 * time);
      const between = fromOffset.clone().applyQuaternion(new THREE.Quaternion().slerp(turn, share));
      between.setLength(fromOffset.length() ** (1 - share) * offset.length() ** share);
      this.go(fromCentre.clone().lerp(centre, share), between);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  // Flies to where the points fill the left share `free` of the view, seen from a direction.
  flyToSee(points, direction, free) {
    const back = vector(direction).normalize();
    const right = new THREE.Vector3(0, 0, 1).cross(back).normalize(), up = back.clone().cross(right);
    const slopeX = this.slope * this.camera.aspect;
    const middleAlong = (axis) => {
      const places = points.map((point) => point.dot(axis));
      return (Math.min(...places) + Math.max(...places)) / 2;
    };
    const centre = new THREE.Vector3();
    for (const axis of [right, up, back]) centre.addScaledVector(axis, middleAlong(axis));
    let distance = 0;
    for (const point of points) {
      const q = point.clone().sub(centre);
      const away = Math.max(Math.abs(q.dot(right)) / (slopeX * free), Math.abs(q.dot(up)) / this.slope);
      distance = Math.max(distance, q.dot(back) + away);
    }
    distance *= 1.15;
    centre.addScaledVector(right, (1 - free) * slopeX * distance);
    this.fly(centre, back.multiplyScalar(distance));
  }

  // Flies to where a ball fills the view, seen from a direction.
  flyToBall(centre, radius, direction) {
    this.fly(centre, direction.clone().setLength(radius / (this.slope * Math.min(1, this.camera.aspect))));
  }
}
