// The picture of mesh and lattice: three.js with a camera that orbits. It is drawn when something has changed.
// SPDX-License-Identifier: Apache-2.0

import * as THREE from "three";
import { OrbitControls } from "three-orbit";

const DARK = matchMedia("(prefers-color-scheme: dark)");
const COLOURS = {
  light: { ground: 0xf3f5f7, mesh: 0x8ea3b8, line: 0x7c8794, point: 0xc04000, chosen: 0x0060a8 },
  dark: { ground: 0x12161b, mesh: 0x8296ab, line: 0x5d6873, point: 0xff8a5c, chosen: 0x7cc0ff },
};

/** Whether a processor draws, since there is no graphics processor. */
function isSoftware(renderer) {
  const context = renderer.getContext();
  const named = context.getExtension("WEBGL_debug_renderer_info");
  const name = named ? context.getParameter(named.UNMASKED_RENDERER_WEBGL) : "";
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** A round dot, since points are squares. */
function dot() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.fillStyle = "white";
  pen.arc(32, 32, 30, 0, 2 * Math.PI);
  pen.fill();
  return new THREE.CanvasTexture(canvas);
}

function points(size, map) {
  const material = new THREE.PointsMaterial({ size, map, sizeAttenuation: false, alphaTest: 0.5 });
  return new THREE.Points(new THREE.BufferGeometry(), material);
}

/** Pairs of neighbours along each axis. */
function edges([a, b, c]) {
  const pairs = [];
  for (let i = 0; i < a; ++i) {
    for (let j = 0; j < b; ++j) {
      for (let k = 0; k < c; ++k) {
        const at = (i * b + j) * c + k;
        if (i + 1 < a) pairs.push(at, at + b * c);
        if (j + 1 < b) pairs.push(at, at + c);
        if (k + 1 < c) pairs.push(at, at + 1);
      }
    }
  }
  return pairs;
}

/** Right, up and backwards of a camera, in the world. */
export function axesOf(camera) {
  return [0, 1, 2].map((column) => new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, column));
}

export class Scene {
  /** @throws Error where the browser has no WebGL */
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas });
    this.renderer.debug.checkShaderErrors = false;  // which waits for the compiler of shaders, many times
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.addEventListener("change", () => this.changed());
    this.build();
    this.paint();
    DARK.addEventListener("change", () => this.paint());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  /** Without a graphics processor there is one point of light a vertex, and edges are not smoothed by more pixels. */
  build() {
    const software = isSoftware(this.renderer);
    this.scene = new THREE.Scene();
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(),
      software ? new THREE.MeshLambertMaterial({ side: THREE.DoubleSide }) :
        new THREE.MeshPhongMaterial({ specular: 0x30343a, shininess: 24, side: THREE.DoubleSide }));
    this.lines = new THREE.LineSegments(new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ transparent: true, opacity: 0.55 }));
    const map = dot();
    this.points = points(8, map);
    this.chosen = points(17, map);
    this.chosen.visible = false;
    for (const one of [this.mesh, this.lines, this.points, this.chosen]) one.frustumCulled = false;
    this.light = new THREE.DirectionalLight(0xffffff, 0.85);
    this.scene.add(this.mesh, this.lines, this.points, this.chosen, this.light, this.light.target,
      new THREE.HemisphereLight(0xffffff, 0x404850, 0.45));
    this.renderer.setPixelRatio(software ? 1 : 2);
  }

  paint() {
    const colours = COLOURS[DARK.matches ? "dark" : "light"];
    this.renderer.setClearColor(colours.ground);
    this.mesh.material.color.set(colours.mesh);
    this.lines.material.color.set(colours.line);
    this.points.material.color.set(colours.point);
    this.chosen.material.color.set(colours.chosen);
    this.changed();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.changed();
  }

  /** Draws before the next picture of the browser, once however much has changed. */
  changed() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.light.position.copy(this.camera.position).add(this.camera.up);
      this.light.target.position.copy(this.controls.target);
      this.renderer.render(this.scene, this.camera);
    });
  }

  setMesh({ positions, indices }) {
    this.mesh.geometry.dispose();
    const geometry = new THREE.BufferGeometry();
    const short = positions.length / 3 <= 65536;
    geometry.setIndex(new THREE.BufferAttribute(short ? new Uint16Array(indices) : indices, 1));
    geometry.setAttribute("position", new THREE.BufferAttribute(positions.slice(), 3));
    this.mesh.geometry = geometry;
    this.moveMesh(positions);
  }

  /** The same vertices in other places. */
  moveMesh(positions) {
    const attribute = this.mesh.geometry.attributes.position;
    attribute.array.set(positions);
    attribute.needsUpdate = true;
    this.mesh.geometry.computeVertexNormals();
    this.changed();
  }

  setLattice(dims, positions) {
    this.lines.geometry.dispose();
    this.points.geometry.dispose();
    const shared = new THREE.BufferAttribute(new Float32Array(positions), 3);
    this.lines.geometry = new THREE.BufferGeometry();
    this.lines.geometry.setIndex(edges(dims));
    this.lines.geometry.setAttribute("position", shared);
    this.points.geometry = new THREE.BufferGeometry();
    this.points.geometry.setAttribute("position", shared);
    this.changed();
  }

  moveLattice(positions) {
    const attribute = this.points.geometry.attributes.position;
    attribute.array.set(positions);
    attribute.needsUpdate = true;
    this.changed();
  }

  /** Shows one control point larger, none if null. */
  choose(place) {
    this.chosen.visible = place !== null;
    if (place !== null) {
      this.chosen.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(place), 3));
    }
    this.changed();
  }

  /** Places the camera so that all of these positions are just seen. */
  look(positions, from = [0.55, 0.3, 1]) {
    const centre = new THREE.Box3().setFromArray(positions).getCenter(new THREE.Vector3());
    this.controls.target.copy(centre);
    this.camera.position.set(...from).add(centre);
    this.camera.lookAt(centre);
    this.camera.updateMatrixWorld();
    const [right, up, back] = axesOf(this.camera);
    const high = Math.tan(this.camera.fov * Math.PI / 360) * 0.94;
    const spot = new THREE.Vector3();
    let distance = 0;
    for (let at = 0; at < positions.length; at += 3) {
      spot.fromArray(positions, at).sub(centre);
      const beside = Math.max(Math.abs(spot.dot(up)), Math.abs(spot.dot(right)) / this.camera.aspect);
      distance = Math.max(distance, beside / high + spot.dot(back));
    }
    this.camera.position.copy(centre).addScaledVector(back, distance);
    this.camera.near = distance / 100;
    this.camera.far = distance * 100;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.changed();
  }

  /** Turns the camera around what it looks at, by angles, and goes nearer or farther by a factor. */
  orbit(across, up, farther = 1) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const place = new THREE.Spherical().setFromVector3(offset);
    place.theta += across;
    place.phi = Math.min(Math.max(place.phi + up, 0.05), Math.PI - 0.05);
    place.radius *= farther;
    this.camera.position.setFromSpherical(place).add(this.controls.target);
    this.controls.update();
    this.changed();
  }
}
