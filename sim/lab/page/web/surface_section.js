/* surface_section.js - surfaces in WebGL, turned by mouse, touch and keys; coloured by isovalue or by
 * node. */

function surfaceSummary(data) {
    return {
        kind: 'Surface',
        big: plural(data.header.faces, 'polygon'),
        small: plural(data.header.vertices, 'vertex', 'vertices')
    };
}

const SLOW_PICTURE = 120;  /* ms */
const COARSE_CELLS = 48;   /* along the longest side */
const FRONT_SIDE = 0, BACK_SIDE = 1; /* of three.js, as numbers */
const MOST_OPACITY = 0.35; /* of a surface that is seen through */

function surfaceSection(surfaces) {
    const section = addSection('Surfaces', 'Surfaces',
        surfaces.length > 1 ? 'The surfaces as the nodes computed them, together.'
                            : `The surface as the nodes computed it (${surfaces[0].name}).`);
    const canvas = element('canvas', {
        tabindex: '0',
        role: 'application',
        'aria-label': 'Surfaces. Arrow keys turn, plus and minus zoom, 0 shows all.'
    });
    const plot = element('div', {class: 'plot surface'}, canvas);
    const view = new SurfaceView(canvas, surfaces);
    const nodes = surfaces.some(s => s.data.node), key = nodeLegend(surfaces);
    section.append(element('div', {class: 'controls'},
                       element('span', {class: 'group', role: 'group', 'aria-label': 'Turn and zoom'},
                           button('◀', () => view.turn(-0.2, 0), {'aria-label': 'Turn left'}),
                           button('▶', () => view.turn(0.2, 0), {'aria-label': 'Turn right'}),
                           button('▲', () => view.turn(0, -0.2), {'aria-label': 'Turn up'}),
                           button('▼', () => view.turn(0, 0.2), {'aria-label': 'Turn down'}),
                           button('−', () => view.zoom(1.25), {'aria-label': 'Zoom out'}),
                           button('+', () => view.zoom(0.8), {'aria-label': 'Zoom in'}),
                           button('All', () => view.showAll())),
                       choice('colour',
                           [
                               ['surface', 'of the surface'],
                               ...(nodes ? [['node', 'of the node that made each polygon']] : [])
                           ],
                           'surface',
                           v => {
                               view.colourBy(v);
                               key.hidden = v !== 'node';
                           }),
                       checkbox('turn by itself', false, on => view.spin(on))),
        plot, surfaceLegend(surfaces, view), key,
        element('p', {class: 'note hint'},
            'Drag to turn, wheel or two fingers to zoom, right button or two fingers to move. Keys: ',
            keys('← → ↑ ↓'), ' turn, ', keys('+ −'), ' zoom, ', keys('0'), ' everything.'));
    view.outerClear();
    onWidth(plot, width => view.resize(width));
    return section;
}

/* Which colour is whose node, of the first nodes. */
function nodeLegend(surfaces) {
    const found = new Set(surfaces.flatMap(s => [...new Set(s.data.node || [])])), most = 64;
    const nodes = [...found].sort((a, b) => a - b);
    const keys = nodes.slice(0, most).map(node => {
        const box = element('span', {class: 'swatch'});
        box.style.backgroundColor = screenTone(nodeTone(node));
        return element('li', {class: 'key'}, box, `node ${node}`);
    });
    const rest =
        nodes.length > most ? element('li', {class: 'key'}, `and ${nodes.length - most} more`) : null;
    return element('ul', {class: 'legend', hidden: true}, keys, rest);
}

/* A button a surface, which shows or hides it, and how much of it is seen through. */
function surfaceLegend(surfaces, view) {
    return element('ul', {class: 'legend'}, surfaces.map((s, i) => {
        const box = element('span', {class: 'swatch'});
        box.style.backgroundColor = screenTone(surfaceTone(i));
        const b = button('', () => {
            const shown = view.toggle(i);
            b.setAttribute('aria-pressed', String(shown));
        }, {'aria-pressed': 'true'});
        b.append(box, `${baseName(s.name)}, ${plural(s.data.header.faces, 'polygon')}`);
        const clear = checkbox('see through', false, on => view.seeThrough(i, on));
        view.clearBoxes.push(clear.querySelector('input'));
        return element('li', {class: 'key'}, b, clear);
    }));
}

/* Where the viewer is, as for touchstone render: azimuth around the z axis from x to y, and elevation, in
 * degrees. */
function viewerDirection(azimuth, elevation) {
    const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
    return new THREE.Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
}

class SurfaceView {
    constructor(canvas, surfaces) {
        this.canvas = canvas;
        canvas.view = this; /* for whoever drives the page */
        this.renderer = new THREE.WebGLRenderer({canvas, preserveDrawingBuffer: true});
        this.picture = new LinearPicture(this.renderer);
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
        this.camera.up.set(0, 0, 1); /* as in touchstone render */
        this.upright = new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0));
        this.clearBoxes = [];
        this.clear = MOST_OPACITY;
        this.meshes = surfaces.map((s, i) => this.makeMesh(s.data, i));
        this.whole = this.meshes.map(m => m.geometry);
        this.coarseGeometry = [];
        this.late = 0; /* how many pictures in a row came late */
        this.scene.add(...this.meshes);
        this.controls = new THREE.OrbitControls(this.camera, canvas);
        this.controls.addEventListener('change', () => this.draw(true));
        canvas.addEventListener('keydown', e => this.key(e));
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
        this.showAll();
    }
    makeMesh({place, corner, normal, node}, i) {
        const split = node ? splitByNode(place, corner, normal, node) : {place, corner, normal};
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', new THREE.BufferAttribute(split.place, 3));
        geometry.setIndex(new THREE.BufferAttribute(
            new Uint32Array(split.corner.buffer, split.corner.byteOffset, split.corner.length), 1));
        geometry.setAttribute(
            'normal', new THREE.BufferAttribute(split.normal || vertexNormals(split.place, split.corner), 3));
        if (split.colours)
            geometry.setAttribute('color', new THREE.BufferAttribute(split.colours, 3, true));
        const near = surfaceMaterial(surfaceTone(i)), mesh = new THREE.Mesh(geometry, near);
        mesh.far = new THREE.Mesh(geometry, surfaceMaterial(surfaceTone(i)));
        Object.assign(mesh.far.material, {uniforms: near.uniforms, side: BACK_SIDE});
        mesh.far.visible = false;
        return mesh.add(mesh.far);
    }
    resize(width) {
        this.width = width;
        const height = this.canvas.clientHeight || 400;
        this.share = 0; /* the picture has a new size */
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        if (this.untouched)
            this.showAll();
        this.draw();
    }
    /* Draws before the browser shows the next picture. Where pictures of all triangles take long, for
     * want of a graphics processor, the browser asks for the next one late. Then a coarse one is drawn
     * while the surfaces move, and all of them when they stand still. */
    draw(moving) {
        clearTimeout(this.still);
        this.untouched = this.untouched && !moving;
        if (moving && this.late > 1)
            this.still = setTimeout(() => this.draw(), 500);
        this.coarse = Boolean(moving && this.late > 1);
        if (this.waiting)
            return;
        const asked = performance.now();
        this.waiting = requestAnimationFrame(() => {
            this.waiting = 0;
            if (moving && !this.coarse)
                this.late = performance.now() - asked > SLOW_PICTURE ? this.late + 1 : 0;
            this.render();
        });
    }
    render() {
        this.meshes.forEach((m, i) => {
            m.geometry = m.far.geometry = this.coarse ? this.coarseOf(i) : this.whole[i];
        });
        this.setPixels(this.coarse ? 0.5 : 1);
        this.renderer.setClearColor(colour('panel'));
        this.picture.render(this.scene, this.camera);
    }
    /* How many pixels are drawn: a share of those that the screen has. */
    setPixels(share) {
        if (this.share === share)
            return;
        this.share = share;
        this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2) * share);
    }
    /* The same surface with the triangles that are left when all vertices within a cell of space are one. */
    coarseOf(i) {
        if (this.coarseGeometry[i])
            return this.coarseGeometry[i];
        const geometry = new THREE.BufferGeometry(), {attributes, index} = this.whole[i];
        Object.assign(geometry.attributes, attributes);
        geometry.setIndex(
            new THREE.BufferAttribute(coarseCorners(attributes.position.array, index.array), 1));
        return this.coarseGeometry[i] = geometry;
    }
    /* Puts the camera where all is seen, obliquely from the front. */
    showAll() {
        const box = new THREE.Box3();
        this.meshes.forEach(m => box.expandByObject(m));
        const middle = box.getCenter(new THREE.Vector3()),
              size = box.getSize(new THREE.Vector3()).length() || 1;
        const distance = 1.03 * this.distanceFor(box, middle, viewerDirection(60, 20));
        this.camera.near = size / 200;
        this.camera.far = size * 20;
        this.camera.position.copy(middle).add(viewerDirection(60, 20).multiplyScalar(distance));
        this.camera.updateProjectionMatrix();
        this.controls.target.copy(middle);
        this.controls.update();
        this.draw();
        this.untouched = true;
    }
    /* From how far in that direction the whole box is seen: no corner leaves the picture, whatever its
     * shape. */
    distanceFor(box, middle, towards) {
        const right = new THREE.Vector3(0, 0, 1).cross(towards).normalize(),
              up = towards.clone().cross(right);
        const high = Math.tan(this.camera.fov / 2 * Math.PI / 180), wide = high * this.camera.aspect;
        let least = 1e-6;
        for (let k = 0; k < 8; k++) {
            const corner = new THREE.Vector3(
                ...['x', 'y', 'z'].map((axis, i) => (k >> i & 1 ? box.max : box.min)[axis] - middle[axis]));
            least = Math.max(least, corner.dot(towards) + Math.max(Math.abs(corner.dot(right)) / wide,
                                                              Math.abs(corner.dot(up)) / high));
        }
        return least;
    }
    /* Turns around the middle: angles in radians, to the right and down. */
    turn(right, down) {
        const spot = new THREE.Spherical().setFromVector3(
            this.camera.position.clone().sub(this.controls.target).applyQuaternion(this.upright));
        spot.theta += right;
        spot.phi = Math.min(Math.PI - 0.02, Math.max(0.02, spot.phi + down));
        this.camera.position.setFromSpherical(spot)
            .applyQuaternion(this.upright.clone().invert())
            .add(this.controls.target);
        this.controls.update();
        this.draw(true);
    }
    zoom(factor) {
        this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
        this.controls.update();
        this.draw(true);
    }
    key(e) {
        const actions = {
            ArrowLeft: () => this.turn(-0.12, 0),
            ArrowRight: () => this.turn(0.12, 0),
            ArrowUp: () => this.turn(0, -0.12),
            ArrowDown: () => this.turn(0, 0.12),
            '+': () => this.zoom(0.85),
            '=': () => this.zoom(0.85),
            '-': () => this.zoom(1 / 0.85),
            0: () => this.showAll()
        };
        if (!actions[e.key] || e.ctrlKey || e.metaKey || e.altKey)
            return;
        e.preventDefault();
        actions[e.key]();
    }
    spin(on) {
        this.spinning = on;
        const step = () => {
            if (!this.spinning)
                return;
            this.turn(0.01, 0);
            requestAnimationFrame(step);
        };
        step();
    }
    toggle(i) {
        this.meshes[i].visible = !this.meshes[i].visible;
        this.draw();
        return this.meshes[i].visible;
    }
    /* Through a surface its far side is seen. It is drawn by itself, as it is behind all that the
     * surface is around. */
    seeThrough(i, on) {
        const {material, far} = this.meshes[i];
        for (const m of [material, far.material])
            Object.assign(m, {transparent: on, depthWrite: !on, needsUpdate: true});
        material.side = on ? FRONT_SIDE : THREE.DoubleSide;
        material.uniforms.opacity.value = on ? this.clear : 1;
        far.visible = on;
        this.draw();
    }
    /* Surfaces around others are seen through; the more of them, the more so (lab/render/render_output.c).
     * Their near sides are drawn after what is within them, their far sides before, with which both blend. */
    outerClear() {
        const boxes = this.meshes.map(m => new THREE.Box3().setFromObject(m));
        const encloses = (a, b) => !b.isEmpty() && a.containsBox(b) && !a.equals(b);
        const within = boxes.map(a => boxes.filter(b => encloses(a, b)).length);
        this.clear = Math.min(MOST_OPACITY, 1 - 0.25 ** (1 / Math.max(1, within.filter(n => n).length)));
        within.forEach((n, i) => {
            this.meshes[i].renderOrder = n;
            this.meshes[i].far.renderOrder = -n;
            if (n)
                this.seeThrough(i, this.clearBoxes[i].checked = true);
        });
    }
    colourBy(what) {
        this.meshes.forEach(m => {
            const vertexColors = what === 'node' && Boolean(m.geometry.attributes.color);
            for (const {material} of [m, m.far])
                Object.assign(material, {vertexColors, needsUpdate: true});
        });
        this.draw();
    }
}

/* For each vertex, the first one of its cell stands; triangles with three different ones stay. */
function coarseCorners(place, corner) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity],
          cells = COARSE_CELLS;
    for (let i = 0; i < place.length; i++) {
        low[i % 3] = Math.min(low[i % 3], place[i]);
        high[i % 3] = Math.max(high[i % 3], place[i]);
    }
    const size = Math.max(...high.map((h, k) => h - low[k]), 1e-30) / cells, first = new Map();
    const cell = i => Math.floor((place[i] - low[i % 3]) / size);
    const stands = new Uint32Array(place.length / 3), kept = [];
    for (let v = 0; v < stands.length; v++) {
        const key = (cell(3 * v) * (cells + 1) + cell(3 * v + 1)) * (cells + 1) + cell(3 * v + 2);
        if (!first.has(key))
            first.set(key, v);
        stands[v] = first.get(key);
    }
    for (let t = 0; t < corner.length; t += 3) {
        const a = stands[corner[t]], b = stands[corner[t + 1]], c = stands[corner[t + 2]];
        if (a !== b && b !== c && c !== a)
            kept.push(a, b, c);
    }
    return new Uint32Array(kept);
}

/* Normals of vertices: the sum of their triangles', by area. */
function vertexNormals(place, corner) {
    const sums = new Float32Array(place.length);
    for (let t = 0; t < corner.length; t += 3) {
        const a = corner[t] * 3, b = corner[t + 1] * 3, c = corner[t + 2] * 3;
        const ux = place[b] - place[a], uy = place[b + 1] - place[a + 1], uz = place[b + 2] - place[a + 2];
        const vx = place[c] - place[a], vy = place[c + 1] - place[a + 1], vz = place[c + 2] - place[a + 2];
        for (const at of [a, b, c]) {
            sums[at] += uy * vz - uz * vy;
            sums[at + 1] += uz * vx - ux * vz;
            sums[at + 2] += ux * vy - uy * vx;
        }
    }
    for (let i = 0; i < sums.length; i += 3) {
        const length = Math.hypot(sums[i], sums[i + 1], sums[i + 2]) || 1;
        sums[i] /= length;
        sums[i + 1] /= length;
        sums[i + 2] /= length;
    }
    return sums;
}

/* Colours by node: a vertex where polygons of several nodes meet is doubled, one for each node; its normal
 * stays. */
function splitByNode(place, corner, normal, node) {
    const normals = normal || vertexNormals(place, corner), count = place.length / 3,
          owner = new Int32Array(count).fill(-2), extra = new Map();
    const corners = new Int32Array(corner), from = [];
    for (let t = 0; t < node.length; t++)
        for (let k = 3 * t; k < 3 * t + 3; k++) {
            const v = corner[k];
            if (owner[v] === -2)
                owner[v] = node[t];
            if (owner[v] === node[t])
                continue;
            const key = v * 2 ** 21 + node[t]; /* there are up to 2^20 nodes */
            if (!extra.has(key)) {
                extra.set(key, count + from.length / 2);
                from.push(v, node[t]);
            }
            corners[k] = extra.get(key);
        }
    return withExtra(place, normals, owner, corners, from);
}

function withExtra(place, normals, owner, corners, from) {
    const count = owner.length, all = count + from.length / 2, tones = new Map();
    const result = {
        place: new Float32Array(all * 3),
        normal: new Float32Array(all * 3),
        colours: new Uint8Array(all * 3),
        corner: corners
    };
    result.place.set(place);
    result.normal.set(normals);
    for (let i = 0; i < all; i++) {
        const source = i < count ? i : from[(i - count) * 2],
              node = i < count ? owner[i] : from[(i - count) * 2 + 1];
        if (i >= count)
            for (let k = 0; k < 3; k++) {
                result.place[i * 3 + k] = place[source * 3 + k];
                result.normal[i * 3 + k] = normals[source * 3 + k];
            }
        if (!tones.has(node)) {
            const tone = d3.rgb(screenTone(nodeTone(node)));
            tones.set(node, [tone.r, tone.g, tone.b]);
        }
        result.colours.set(tones.get(node), i * 3);
    }
    return result;
}
