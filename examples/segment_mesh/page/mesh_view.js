"use strict";

// The mesh on a canvas, by three.js. Every corner has the number of its region; tables from regions to colors and to segments
// are textures, so that another segmentation takes no more than new tables.
class MeshView {
  constructor(canvas) {
    this.canvas = canvas;
    this.afterDrawing = () => {};
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true});
    this.renderer.autoClear = false;
    this.ids = new THREE.WebGLRenderTarget(1, 1, {minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    this.tables = {colors: {value: null}, segments: {value: null}, tableSize: {value: new THREE.Vector2()}, explosion: {value: 0}};
    this.camera = new THREE.PerspectiveCamera(30);
    this.surface = this.makeScene(MeshView.surfaceShader);
    this.regions = this.makeScene(MeshView.regionShader);
    this.lines = this.makeLines();
    this.overlay = new THREE.Scene(); // what is drawn on the mesh
    this.makeControls();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    const draw = () => {
      if (this.geometry) this.controls.update();
      if (this.isStale) this.draw();
      requestAnimationFrame(draw);
    };
    draw();
  }

  /// \param mesh points, sizes, corners: arrays; the corners of a face one after the other
  setMesh(mesh, view) {
    const {geometry, facesOfTriangles} = MeshView.makeGeometry(mesh);
    geometry.computeBoundingSphere();
    if (this.geometry) this.geometry.dispose();
    this.geometry = geometry;
    this.facesOfTriangles = facesOfTriangles;
    for (const scene of [this.surface, this.regions]) scene.children[0].geometry = geometry;
    this.radius = geometry.boundingSphere.radius || 1;
    this.toward = new THREE.Vector3(...view.toward);
    Object.assign(this.camera, {near: 0.01 * this.radius, far: 100 * this.radius});
    this.camera.up.set(...view.up);
    Object.assign(this.controls, {minDistance: 0.3 * this.radius, maxDistance: 30 * this.radius});
    this.isPlaced = false;
    this.isHidden = null;
  }

  /// \param regions by face
  setRegions(regions, numberOfRegions) {
    const width = 256, height = Math.ceil(numberOfRegions / width);
    for (const table of [this.tables.colors, this.tables.segments]) {
      if (table.value) table.value.dispose();
      table.value = MeshView.makeTable(width, height);
    }
    this.tables.tableSize.value.set(width, height);
    const ofCorners = this.geometry.getAttribute("region");
    this.facesOfTriangles.forEach((face, t) => ofCorners.array.fill(regions[face], 3 * t, 3 * t + 3));
    this.isHidden = new Uint8Array(numberOfRegions);
    ofCorners.needsUpdate = true;
    this.resize();
  }

  static makeTable(width, height) {
    const table = new THREE.DataTexture(new Uint8Array(4 * width * height), width, height, THREE.RGBAFormat);
    table.magFilter = table.minFilter = THREE.NearestFilter;
    return table;
  }

  makeScene(shader) {
    const material = new THREE.ShaderMaterial({...shader, uniforms: this.tables, side: THREE.DoubleSide});
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(new THREE.BufferGeometry(), material));
    return scene;
  }

  makeLines() {
    const uniforms = {...this.tables, ids: {value: this.ids.texture}, pixel: {value: new THREE.Vector2()}, reach: {value: new THREE.Vector2()}};
    const material = new THREE.ShaderMaterial({...MeshView.lineShader, uniforms, transparent: true, depthTest: false, depthWrite: false});
    const scene = new THREE.Scene();
    const quad = new THREE.Mesh(new THREE.PlaneBufferGeometry(2, 2), material);
    quad.frustumCulled = false;
    scene.add(quad);
    return {scene, uniforms};
  }

  makeControls() {
    this.controls = new THREE.TrackballControls(this.camera, this.canvas);
    Object.assign(this.controls, {rotateSpeed: 3.2, zoomSpeed: 1.1, panSpeed: 0.5, dynamicDampingFactor: 0.18, keys: []});
    this.controls.addEventListener("change", () => { this.areIdsStale = this.isStale = true; });
  }

  /// Turns the mesh to the right and up, in radians, as a drag in these directions does.
  turn(right, up) {
    const {camera} = this, eye = camera.position.clone().sub(this.controls.target);
    const sideways = new THREE.Vector3().crossVectors(camera.up, eye).normalize();
    const rotation = new THREE.Quaternion().setFromAxisAngle(camera.up.clone().normalize(), -right)
      .premultiply(new THREE.Quaternion().setFromAxisAngle(sideways, up));
    camera.up.applyQuaternion(rotation);
    camera.position.copy(this.controls.target).add(eye.applyQuaternion(rotation));
  }

  /// Multiplies the distance of the viewer.
  zoom(factor) {
    const {position} = this.camera, {target} = this.controls;
    position.sub(target).multiplyScalar(factor).add(target);
  }

  resize() {
    const {clientWidth: width, clientHeight: height} = this.canvas.parentElement;
    if (width === 0 || height === 0 || !this.geometry) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    const size = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    this.ids.setSize(size.x, size.y);
    this.lines.uniforms.pixel.value.set(1 / size.x, 1 / size.y);
    this.lines.uniforms.reach.value.copy(this.lines.uniforms.pixel.value).multiplyScalar(1.25 * this.renderer.getPixelRatio());
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.isPlaced) this.place();
    this.controls.handleResize();
    this.areIdsStale = this.isStale = true;
  }

  /// Moves each segment by this part of the way from the center of the mesh to its own; the viewer steps back as the picture
  /// grows.
  explode(part, segmentOfRegion) {
    const {explosion} = this.tables;
    if (part !== explosion.value) this.zoom((1 + part) / (1 + explosion.value));
    explosion.value = part;
    this.areIdsStale = this.isStale = true;
    if (part === 0) return;
    const {position: {array: positions}, region: {array: regions}, offset} = this.geometry.attributes, sums = [];
    regions.forEach((region, i) => {
      const sum = sums[segmentOfRegion[region]] = sums[segmentOfRegion[region]] || [0, 0, 0, 0];
      for (let j = 0; j < 3; ++j) sum[j] += positions[3 * i + j];
      ++sum[3];
    });
    const center = this.geometry.boundingSphere.center.toArray();
    this.offsets = sums.map(sum => center.map((x, j) => sum[j] / sum[3] - x));
    regions.forEach((region, i) => offset.array.set(this.offsets[segmentOfRegion[region]], 3 * i));
    offset.needsUpdate = true;
  }

  /// The point of a corner as it is shown.
  pointAt(i, point) {
    const {position, offset} = this.geometry.attributes, part = this.tables.explosion.value;
    return point.set(...[0, 1, 2].map(j => position.array[3 * i + j] + part * offset.array[3 * i + j]));
  }

  /// All that is not hidden, seen from the same side.
  fit() {
    this.toward = this.camera.position.clone().sub(this.controls.target).normalize();
    this.camera.up.addScaledVector(this.toward, -this.camera.up.dot(this.toward)).normalize();
    this.place();
  }

  /// Where the ball around the box of all that is not hidden is seen.
  place() {
    const regions = this.geometry.getAttribute("region").array, box = new THREE.Box3(), p = new THREE.Vector3();
    regions.forEach((region, i) => {
      if (!this.isHidden || !this.isHidden[region]) box.expandByPoint(this.pointAt(i, p));
    });
    const {center, radius} = box.getBoundingSphere(new THREE.Sphere());
    const distance = (radius || this.radius) / Math.sin(this.camera.fov / 2 * Math.PI / 180) / Math.min(1, this.camera.aspect);
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(this.toward, distance);
    this.isPlaced = true;
    this.areIdsStale = this.isStale = true;
  }

  /// \param colorOfRegion red, green, blue, from 0 to 255
  /// \param isHidden by region
  /// \param selected segments, which get an outline
  show(segmentOfRegion, colorOfRegion, glowOfRegion, isHidden, selected) {
    const colors = this.tables.colors.value.image.data, segments = this.tables.segments.value.image.data;
    segmentOfRegion.forEach((segment, region) => {
      colors.set(colorOfRegion(region), 4 * region);
      colors[4 * region + 3] = glowOfRegion(region);
      segments.set([segment & 255, segment >> 8 & 255, segment >> 16 & 255, isHidden[region] ? 0 : selected.includes(segment) ? 255 : 192], 4 * region);
    });
    this.areIdsStale = this.areIdsStale || isHidden.some((hides, region) => hides !== this.isHidden[region]);
    this.isHidden = isHidden.slice();
    this.tables.colors.value.needsUpdate = this.tables.segments.value.needsUpdate = true;
    this.isStale = true;
  }

  draw() {
    this.isStale = false;
    const renderer = this.renderer;
    renderer.setClearColor(0x000000, 0);
    if (this.areIdsStale) {
      renderer.setRenderTarget(this.ids);
      renderer.clear();
      renderer.render(this.regions, this.camera);
      renderer.setRenderTarget(null);
      this.areIdsStale = false;
    }
    renderer.clear();
    renderer.render(this.surface, this.camera);
    renderer.render(this.lines.scene, this.camera);
    renderer.render(this.overlay, this.camera);
    this.afterDrawing();
  }

  /// The region at a place of the canvas, -1 of the background.
  regionAt(x, y) {
    if (this.areIdsStale) this.draw();
    const ratio = this.renderer.getPixelRatio(), pixel = new Uint8Array(4);
    this.renderer.readRenderTargetPixels(this.ids, Math.floor(x * ratio), this.ids.height - 1 - Math.floor(y * ratio), 1, 1, pixel);
    return pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
  }

  picture(take) {
    this.draw();
    this.canvas.toBlob(take, "image/png");
  }

  static makeGeometry(mesh) {
    const triangles = MeshView.triangulate(mesh);
    const normals = MeshView.cornerNormals(mesh.points, triangles.corners);
    const positions = new Float32Array(3 * triangles.corners.length);
    triangles.corners.forEach((point, c) => {
      for (let j = 0; j < 3; ++j) positions[3 * c + j] = mesh.points[3 * point + j];
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
    geometry.setAttribute("offset", new THREE.BufferAttribute(new Float32Array(positions.length), 3));
    geometry.setAttribute("region", new THREE.BufferAttribute(new Float32Array(triangles.corners.length), 1));
    return {geometry, facesOfTriangles: triangles.faces};
  }

  /// The corners of triangles, and the face of each.
  static triangulate(mesh) {
    const corners = [], faces = [];
    let first = 0;
    mesh.sizes.forEach((size, face) => {
      const polygon = mesh.corners.subarray(first, first + size);
      first += size;
      const triangles = size === 3 ? [[0, 1, 2]] : size > 3 ? MeshView.triangulatePolygon(mesh.points, polygon) : [];
      for (const triangle of triangles) {
        for (const c of triangle) corners.push(polygon[c]);
        faces.push(face);
      }
    });
    return {corners: Uint32Array.from(corners), faces: Uint32Array.from(faces)};
  }

  /// By projection along the normal.
  static triangulatePolygon(points, polygon) {
    const corners = Array.from(polygon, p => new THREE.Vector3(points[3 * p], points[3 * p + 1], points[3 * p + 2]));
    const normal = new THREE.Vector3();
    for (let i = 1; i + 1 < corners.length; ++i)
      normal.add(corners[i].clone().sub(corners[0]).cross(corners[i + 1].clone().sub(corners[0])));
    const toPlane = new THREE.Quaternion().setFromUnitVectors(normal.normalize(), new THREE.Vector3(0, 0, 1));
    return THREE.ShapeUtils.triangulateShape(corners.map(corner => {
      const c = corner.applyQuaternion(toPlane);
      return new THREE.Vector2(c.x, c.y);
    }), []);
  }

  /// For each corner the mean of the normals round its point, weighted by area, of triangles that are within 40 degrees of
  /// its own: smooth surfaces look smooth, and edges sharp.
  static cornerNormals(points, corners) {
    const smooth = Math.cos(40 * Math.PI / 180), count = corners.length / 3;
    const weighted = new Float64Array(3 * count), unit = new Float64Array(3 * count);
    for (let t = 0; t < count; ++t) {
      const [a, b, c] = [3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2]];
      const u = [0, 1, 2].map(j => points[b + j] - points[a + j]), v = [0, 1, 2].map(j => points[c + j] - points[a + j]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const length = Math.hypot(...n) || 1;
      for (let j = 0; j < 3; ++j) { weighted[3 * t + j] = n[j]; unit[3 * t + j] = n[j] / length; }
    }
    // The triangles round each point, in one array.
    const starts = new Uint32Array(points.length / 3 + 1);
    for (const p of corners) ++starts[p + 1];
    for (let p = 0; p + 1 < starts.length; ++p) starts[p + 1] += starts[p];
    const ends = starts.slice(), around = new Uint32Array(corners.length);
    corners.forEach((p, c) => { around[ends[p]++] = c / 3 | 0; });

    const normals = new Float32Array(3 * corners.length);
    for (let c = 0; c < corners.length; ++c) {
      const own = 3 * (c / 3 | 0), p = corners[c];
      let x = 0, y = 0, z = 0;
      for (let i = starts[p]; i < starts[p + 1]; ++i) {
        const t = 3 * around[i];
        if (unit[own] * unit[t] + unit[own + 1] * unit[t + 1] + unit[own + 2] * unit[t + 2] < smooth) continue;
        x += weighted[t]; y += weighted[t + 1]; z += weighted[t + 2];
      }
      const length = Math.hypot(x, y, z) || 1;
      normals[3 * c] = x / length; normals[3 * c + 1] = y / length; normals[3 * c + 2] = z / length;
    }
    return normals;
  }
}

MeshView.tableLookup = `
  uniform vec2 tableSize;
  vec4 entry(sampler2D table, float region)
  {
    return texture2D(table, (vec2(mod(region, tableSize.x), floor(region / tableSize.x)) + 0.5) / tableSize);
  }
  /// A place in the picture; outside of it where the region is hidden.
  vec4 placeOf(vec4 place, sampler2D segments, float region)
  {
    return entry(segments, region).a > 0.5 ? place : vec4(2.0, 2.0, 2.0, 1.0);
  }`;

/// Lights that move with the viewer: one from the upper left, a weak one from the right, and the sky.
MeshView.surfaceShader = {
  vertexShader: `
    attribute float region;
    attribute vec3 offset;
    uniform sampler2D colors, segments;
    uniform float explosion;
    varying vec3 shownNormal, shownPosition, color;
    varying float glow;
    ${MeshView.tableLookup}
    void main()
    {
      vec4 shown = entry(colors, region);
      color = pow(shown.rgb, vec3(2.2));
      glow = shown.a;
      vec4 position4 = modelViewMatrix * vec4(position + explosion * offset, 1.0);
      shownNormal = normalMatrix * normal;
      shownPosition = position4.xyz;
      gl_Position = placeOf(projectionMatrix * position4, segments, region);
    }`,
  fragmentShader: `
    varying vec3 shownNormal, shownPosition, color;
    varying float glow;
    void main()
    {
      vec3 toViewer = normalize(-shownPosition);
      vec3 n = normalize(shownNormal);
      if (dot(n, toViewer) < 0.0)
        n = -n; // both sides look the same
      vec3 key = normalize(vec3(-0.45, 0.65, 0.75));
      float light = 0.30 + 0.14 * n.y + 0.62 * max(dot(n, key), 0.0) + 0.16 * max(dot(n, normalize(vec3(0.9, 0.0, 0.45))), 0.0);
      float shine = 0.10 * pow(max(dot(n, normalize(key + toViewer)), 0.0), 36.0);
      float rim = pow(1.0 - max(dot(n, toViewer), 0.0), 3.0);
      vec3 shown = color * (light - 0.10 * rim) + shine;
      shown = shown * (1.0 + 0.8 * glow) + 0.06 * glow;
      gl_FragColor = vec4(pow(shown, vec3(1.0 / 2.2)), 1.0);
    }`
};

/// The number of the region and 1 in three bytes; 0 is the background.
MeshView.regionShader = {
  vertexShader: `
    attribute float region;
    attribute vec3 offset;
    uniform sampler2D segments;
    uniform float explosion;
    varying float number;
    ${MeshView.tableLookup}
    void main()
    {
      number = region + 1.0;
      gl_Position = placeOf(projectionMatrix * modelViewMatrix * vec4(position + explosion * offset, 1.0), segments, region);
    }`,
  fragmentShader: `
    varying float number;
    void main()
    {
      float n = floor(number + 0.5);
      gl_FragColor = vec4(mod(n, 256.0), mod(floor(n / 256.0), 256.0), floor(n / 65536.0), 255.0) / 255.0;
    }`
};

/// Dark where segments meet in the picture, and against the background; wide and orange round what is selected.
MeshView.lineShader = {
  vertexShader: "void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }",
  fragmentShader: `
    uniform sampler2D ids, segments;
    uniform vec2 pixel, reach; // of the picture; of a line, to each side
    ${MeshView.tableLookup}
    /// The number in three bytes, and whether it is selected.
    vec4 segmentAt(vec2 at)
    {
      vec3 bytes = floor(texture2D(ids, at).rgb * 255.0 + 0.5);
      float number = bytes.r + 256.0 * bytes.g + 65536.0 * bytes.b;
      vec4 segment = entry(segments, max(number - 1.0, 0.0));
      return number < 0.5 ? vec4(2.0, 2.0, 2.0, 0.0) : vec4(segment.rgb, step(0.9, segment.a));
    }
    void main()
    {
      vec2 at = gl_FragCoord.xy * pixel;
      vec4 here = segmentAt(at);
      float different = 0.0, selected = 0.0;
      for (int i = 0; i < 12; ++i) {
        float angle = 6.2831853 * float(i) / 12.0;
        float radius = i - 2 * (i / 2) == 0 ? 1.0 : 0.55;
        vec2 way = radius * reach * vec2(cos(angle), sin(angle));
        different += any(greaterThan(abs(segmentAt(at + way) - here).rgb, vec3(0.001))) ? 1.0 : 0.0;
        selected += abs(segmentAt(at + 2.6 * way).a - here.a);
      }
      vec4 line = vec4(0.07, 0.09, 0.14, 0.85 * smoothstep(0.0, 0.5, different / 12.0));
      gl_FragColor = mix(line, vec4(1.0, 0.5, 0.0, 1.0), smoothstep(0.0, 0.3, selected / 12.0));
    }`
};
