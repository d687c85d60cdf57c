// ---- meshes ----

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

// Paints the inner side of a mesh evenly where a cut shows it, as a section through the solid is painted.
function paintSections(shader) {
  shader.fragmentShader = shader.fragmentShader.replace('#include <opaque_fragment>',
    'if (NUM_CLIPPING_PLANES > 0 && !gl_FrontFacing) outgoingLight = 0.8 * diffuse;\n#include <opaque_fragment>');
}

// A mesh of several objects, each of which owns a run of the triangles and one of the edges.
class Body {
  constructor(mesh) {
    this.mesh = mesh;
    this.positions = new THREE.BufferAttribute(new Uint16Array(bytesOf(mesh.positions)), 3, true);
    this.corners = new Uint32Array(bytesOf(mesh.triangles));
    this.ends = new Uint32Array(bytesOf(mesh.edges));
    let corner = 0, end = 0;
    this.runs = mesh.objects.map((object) => {
      const run = { corner, corners: 3 * object.triangles, end, ends: 2 * object.edges, isHidden: false };
      corner += run.corners;
      end += run.ends;
      return run;
    });
    this.faces = this.geometryOf(this.corners);
    this.edges = this.geometryOf(this.ends);
  }

  get triangleCount() { return this.corners.length / 3; }

  geometryOf(indices) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', this.positions);
    geometry.setIndex(new THREE.BufferAttribute(indices, 1));
    return geometry;
  }

  // Positions are 16-bit shares of the mesh's box; the matrix of the object scales them back.
  place(object) {
    object.position.fromArray(this.mesh.low);
    object.scale.fromArray(this.mesh.extent);
    object.frustumCulled = false;
    return object;
  }

  facesWith(material) { return this.place(new THREE.Mesh(this.faces, material)); }
  edgesWith(material) { return this.place(new THREE.LineSegments(this.edges, material)); }

  // Leaves the hidden objects out of what is drawn.
  drawVisible() {
    const visible = this.runs.filter((run) => !run.isHidden);
    const gather = (all, first, count) => {
      const made = new Uint32Array(visible.reduce((sum, run) => sum + run[count], 0));
      let at = 0;
      for (const run of visible) {
        made.set(all.subarray(run[first], run[first] + run[count]), at);
        at += run[count];
      }
      return new THREE.BufferAttribute(made, 1);
    };
    this.faces.setIndex(gather(this.corners, 'corner', 'corners'));
    this.edges.setIndex(gather(this.ends, 'end', 'ends'));
  }

  // The box of an object, in the steps of the stored positions.
  boxOf(run) {
    if (run.box) return run.box;
    const box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
    for (let i = run.corner; i < run.corner + run.corners; ++i) {
      for (let axis = 0; axis < 3; ++axis) {
        const value = this.positions.array[3 * this.corners[i] + axis];
        box.low[axis] = Math.min(box.low[axis], value);
        box.high[axis] = Math.max(box.high[axis], value);
      }
    }
    return run.box = box;
  }

  // The nearest visible object on a ray in the mesh's coordinates, between the lengths `from` and `to` along the
  // ray: { object, along }, or null.
  hit(origin, direction, from, to) {
    const { low, extent } = this.mesh;
    const scale = extent.map((size) => 65535 / (size || 1));
    const o = origin.map((value, i) => (value - low[i]) * scale[i]);
    const d = direction.map((value, i) => value * scale[i]);
    let found = null;
    this.runs.forEach((run, object) => {
      if (run.isHidden || !run.corners || !meetsBox(this.boxOf(run), o, d)) return;
      const along = this.hitIn(run, o, d, from, found ? found.along : to);
      if (along !== null) found = { object, along };
    });
    return found;
  }

  // Source: Moeller, Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997.
  hitIn(run, [ox, oy, oz], [dx, dy, dz], from, to) {
    const p = this.positions.array;
    let nearest = null;
    for (let i = run.corner; i < run.corner + run.corners; i += 3) {
      const a = 3 * this.corners[i], b = 3 * this.corners[i + 1], c = 3 * this.corners[i + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const qx = dy * vz - dz * vy, qy = dz * vx - dx * vz, qz = dx * vy - dy * vx;
      const volume = ux * qx + uy * qy + uz * qz;
      if (volume === 0) continue;
      const sx = ox - p[a], sy = oy - p[a + 1], sz = oz - p[a + 2];
      const s = (sx * qx + sy * qy + sz * qz) / volume;
      if (s < 0 || s > 1) continue;
      const rx = sy * uz - sz * uy, ry = sz * ux - sx * uz, rz = sx * uy - sy * ux;
      const t = (dx * rx + dy * ry + dz * rz) / volume;
      if (t < 0 || s + t > 1) continue;
      const along = (vx * rx + vy * ry + vz * rz) / volume;
      if (along > from && along < to) nearest = to = along;
    }
    return nearest;
  }
}

function meetsBox(box, o, d) {
  let from = 0, to = Infinity;
  for (let i = 0; i < 3; ++i) {
    const a = (box.low[i] - 1 - o[i]) / d[i], b = (box.high[i] + 1 - o[i]) / d[i];
    from = Math.max(from, Math.min(a, b));
    to = Math.min(to, Math.max(a, b));
  }
  return from <= to;
}
