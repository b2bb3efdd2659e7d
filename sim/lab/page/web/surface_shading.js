/* surface_shading.js - light and colours of surfaces, as touchstone render has them: colours of surfaces and nodes
 * (lab/render/colours.c), lights, the side that is seen and what a layer holds back (lab/render/shade.c). Light
 * adds up and layers blend in linear light. */

const SURFACE_TONES =
    ['#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#d55e00', '#f0e442', '#0072b2', '#999999'];

/* From the ninth surface on the colours come again, darker. */
function surfaceTone(surface) {
    const light = 0.45 ** Math.floor(surface / SURFACE_TONES.length);
    return new THREE.Color(SURFACE_TONES[surface % SURFACE_TONES.length]).multiplyScalar(light);
}

/* Hues at steps of the golden angle; lightness takes turns. From Oklab. */
function nodeTone(node) {
    if (node < 0)
        return new THREE.Color('#999999');
    const lightness = [0.72, 0.58, 0.82, 0.65][node % 4], hue = 0.6 + node * 2.399963229728653;
    const a = 0.125 * Math.cos(hue), b = 0.125 * Math.sin(hue);
    const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
    const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
    const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
    const linear = [
        4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
        -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
        -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s
    ];
    return new THREE.Color(...linear.map(v => Math.min(1, Math.max(0.01, v))));
}

/* A colour as style sheets and arrays of bytes have it. */
function screenTone(tone) {
    return '#' + tone.getHexString();
}

const SURFACE_CORNER = `
    varying vec3 way, up, tint;
    uniform vec3 tone;
    void main() {
        vec4 place = modelViewMatrix * vec4(position, 1.0);
        way = -place.xyz;
        up = normalMatrix * normal;
        tint = tone;
        #ifdef USE_COLOR
            tint = mix(color / 12.92, pow((color + 0.055) / 1.055, vec3(2.4)), step(0.04045, color));
        #endif
        gl_Position = projectionMatrix * place;
    }`;

/* The light of one place, towards the viewer. Where the outline is near, the triangle tells which side is seen. */
const SURFACE_POINT = `
    varying vec3 way, up, tint;
    uniform float opacity;
    vec3 shine(vec3 normal, vec3 view, vec3 from, vec3 strength) {
        float falls = dot(normal, from);
        float gloss = 0.16 * pow(max(dot(normalize(from + view), normal), 0.0), 32.0);
        return falls > 0.0 ? strength * (falls * tint + gloss) : vec3(0.0);
    }
    void main() {
        vec3 view = normalize(way), normal = normalize(up), plane = cross(dFdx(way), dFdy(way));
        float facing = dot(normal, view);
        float side = abs(facing) < 0.3 ? dot(plane, view) * dot(plane, normal) : facing;
        if (side < 0.0) {
            facing = -facing;
            normal = -normal;
        }
        normal = normalize(normal + max(0.05 - facing, 0.0) * view);
        facing = max(facing, 0.05);
        vec3 light = tint * mix(vec3(0.10, 0.095, 0.09), vec3(0.20, 0.21, 0.22), 0.5 + 0.5 * normal.y);
        light += shine(normal, view, vec3(-0.57, 0.57, 0.59), vec3(0.82, 0.80, 0.77));
        light += shine(normal, view, vec3(0.80, 0.05, 0.60), vec3(0.13, 0.14, 0.16));
        light += shine(normal, view, vec3(0.25, 0.60, -0.76), vec3(0.30, 0.31, 0.33));
        gl_FragColor = vec4(light, opacity < 1.0 ? 1.0 - pow(1.0 - opacity, 1.0 / facing) : 1.0);
    }`;

function surfaceMaterial(tone) {
    return new THREE.ShaderMaterial({
        vertexShader: SURFACE_CORNER,
        fragmentShader: SURFACE_POINT,
        uniforms: {tone: {value: tone}, opacity: {value: 1}},
        side: THREE.DoubleSide
    });
}

/* A picture in linear light, which the graphics processor keeps in the colours of the screen: there it blends as light
 * does, which it does not on a canvas. */
class LinearPicture {
    constructor(renderer) {
        this.renderer = renderer;
        this.target = new THREE.WebGLRenderTarget(1, 1, {samples: 4, colorSpace: THREE.SRGBColorSpace});
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position',
            new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
        this.whole = new THREE.Mesh(geometry, new THREE.ShaderMaterial({
            vertexShader: 'void main() { gl_Position = vec4(position, 1.0); }',
            fragmentShader: `
                uniform sampler2D picture;
                void main() {
                    gl_FragColor = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
                    #include <colorspace_fragment>
                }`,
            uniforms: {picture: {value: this.target.texture}},
            depthTest: false
        }));
        this.whole.frustumCulled = false;
    }
    render(scene, camera) {
        const {width, height} = this.renderer.domElement;
        this.target.setSize(width, height);
        this.renderer.setRenderTarget(this.target);
        this.renderer.render(scene, camera);
        this.renderer.setRenderTarget(null);
        this.renderer.render(this.whole, camera);
    }
}
