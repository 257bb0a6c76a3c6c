// A body of revolution, cut open, in the dent that it makes; turned by the mouse, a finger, or the arrow keys.
// Drawn far to near on a plain canvas: without a graphics card that is ten times faster than a scene in space.
const HOME = { turn: -1.414, rise: 0.576 };
const LIGHT = unit([-0.45, -0.55, 0.7]);
const [LOWEST, HIGHEST] = [0.3, 1.55];
const PARTS = 3; // of a cut face, from below to the lid

function unit([x, y, z]) {
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}

function channels(colour) {
  return [1, 3, 5].map((place) => parseInt(colour.slice(place, place + 2), 16));
}

export default {
  template: `<div class="solid">
    <canvas tabindex="0" role="img" aria-label="The body in three dimensions; arrow keys turn it"></canvas><p></p>
  </div>`,
  props: { first: String, pinned: String },
  mounted() {
    this.view = { ...HOME };
    this.canvas = this.$el.querySelector("canvas");
    this.newest = this.first;
    this.redraw();
    this.watch = new ResizeObserver(() => this.paint());
    this.watch.observe(this.canvas);
    this.canvas.addEventListener("pointerdown", (event) => {
      this.held = [event.clientX, event.clientY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!this.held) return;
      const [x, y] = this.held;
      this.held = [event.clientX, event.clientY];
      this.move(-0.01 * (event.clientX - x), 0.01 * (event.clientY - y));
    });
    for (const name of ["pointerup", "pointercancel"]) this.canvas.addEventListener(name, () => (this.held = null));
    this.canvas.addEventListener("dblclick", () => {
      this.view = { ...HOME };
      this.paint();
    });
    this.canvas.addEventListener("keydown", (event) => {
      const steps = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
      if (!(event.key in steps)) return;
      event.preventDefault();
      this.move(...steps[event.key]);
    });
  },
  beforeUnmount() {
    this.watch.disconnect();
  },
  methods: {
    draw(text) {
      this.newest = text;
      this.requested ??= requestAnimationFrame(() => this.redraw());
    },
    pin() {}, // one body is drawn
    save(_, name) {
      const link = document.createElement("a");
      [link.href, link.download] = [this.canvas.toDataURL("image/png"), `${name}.png`];
      link.click();
    },
    redraw() {
      this.requested = undefined;
      if (!this.$el?.isConnected) return;
      const { data } = JSON.parse(this.newest);
      this.$el.data = data;
      this.$el.querySelector("p").textContent = data.note;
      this.faces = this.built(data);
      this.paint();
    },
    move(turn, rise) {
      this.view.turn += turn;
      this.view.rise = Math.min(Math.max(this.view.rise + rise, LOWEST), HIGHEST);
      this.paint();
    },
    // Every face: its corners, its middle, its outward normal (none: seen from both sides), its colour; `ahead` brings
    // what lies on something else a little nearer.
    built({ ground, body, edge, sectors }) {
      const faces = [];
      const add = (points, colour, outward, ahead) => {
        const [p, q, s, t] = points;
        const middle = [0, 1, 2].map((k) => 0.25 * (p[k] + q[k] + s[k] + t[k]));
        faces.push({ points, middle, colour, outward, ahead });
      };
      const turned = (from, to) =>
        Array.from({ length: sectors + 1 }, (_, k) => from + ((to - from) * k) / sectors).map((turn) => [
          Math.cos(turn),
          Math.sin(turn),
        ]);
      const at = (r, z, [c, s]) => [r * c, r * s, z];
      const strips = ({ r, z }, rays, take) => {
        for (let k = 0; k < sectors; k++)
          for (let i = 0; i + 1 < r.length; i++)
            take(i, k, [
              at(r[i], z[i], rays[k]),
              at(r[i], z[i], rays[k + 1]),
              at(r[i + 1], z[i + 1], rays[k + 1]),
              at(r[i + 1], z[i + 1], rays[k]),
            ]);
      };
      const [dark, light] = body.colours.map(channels);
      const steel = (outward) => {
        const share = Math.abs(outward[0] * LIGHT[0] + outward[1] * LIGHT[1] + outward[2] * LIGHT[2]);
        return `rgb(${dark.map((one, k) => Math.round(one + share * (light[k] - one))).join()})`;
      };
      const open = turned(-0.5 * Math.PI - body.cut, -0.5 * Math.PI + body.cut);
      const solid = turned(body.cut - 0.5 * Math.PI, 1.5 * Math.PI - body.cut);
      for (const [rays, covered] of [[open, 0], [solid, edge.radius]])
        strips(ground, rays, (i, k, points) => {
          if (ground.r[i] >= covered) add(points, ground.colours[i], null, 0); // below the contact nothing is seen
        });
      if (edge.radius > 0)
        for (const rays of [open, solid])
          for (let k = 0; k < sectors; k++) {
            const ends = [at(edge.radius, edge.level, rays[k]), at(edge.radius, edge.level, rays[k + 1])];
            faces.push({ points: ends, middle: ends[0], line: edge.colour, outward: null, ahead: 0.12 });
          }
      const { r, z } = body;
      const last = r.length - 1;
      strips(body, solid, (i, k, points) => {
        const ray = [solid[k][0] + solid[k + 1][0], solid[k][1] + solid[k + 1][1]];
        const half = Math.hypot(...ray);
        const [rise, run] = [z[i + 1] - z[i], r[i + 1] - r[i]];
        const outward = unit([(rise * ray[0]) / half, (rise * ray[1]) / half, -run]);
        add(points, steel(outward), outward, 0.02);
      });
      for (const [ray, side] of [[solid[0], -1], [solid[sectors], 1]]) {
        const outward = [-side * ray[1], side * ray[0], 0];
        for (let i = 0; i < last; i++)
          for (let j = 0; j < PARTS; j++) {
            const up = (k, part) => at(r[k], z[k] + (part / PARTS) * (body.lid - z[k]), ray);
            add([up(i, j), up(i + 1, j), up(i + 1, j + 1), up(i, j + 1)], steel(outward), outward, 0.02);
          }
      }
      const top = [at(0, body.lid, [1, 0]), ...solid.map((ray) => at(r[last], body.lid, ray))];
      faces.push({ points: top, middle: top[0], colour: steel([0, 0, 1]), outward: null, ahead: 9 });
      return faces;
    },
    paint() {
      const { clientWidth: width, clientHeight: height } = this.canvas;
      if (!width || !this.faces) return;
      const fine = Math.min(window.devicePixelRatio || 1, 2);
      if (this.canvas.width !== Math.round(width * fine) || this.canvas.height !== Math.round(height * fine)) {
        this.canvas.width = Math.round(width * fine);
        this.canvas.height = Math.round(height * fine);
      }
      const { turn, rise } = this.view;
      const [ct, st, cr, sr] = [Math.cos(turn), Math.sin(turn), Math.cos(rise), Math.sin(rise)];
      const tall = this.$el.data.tall;
      const size = Math.min(width / 2.06, height / (2 * sr + tall * cr + 0.06));
      const pen = this.canvas.getContext("2d");
      pen.setTransform(fine, 0, 0, fine, 0.5 * width * fine, 0.5 * height * fine);
      pen.clearRect(-width, -height, 2 * width, 2 * height);
      pen.lineJoin = "round";
      const near = ([x, y, z]) => cr * (ct * x + st * y) + sr * z;
      const seen = this.faces.filter(({ outward }) => !outward || near(outward) > 0);
      for (const face of seen) face.near = near(face.middle) + face.ahead;
      seen.sort((one, other) => one.near - other.near);
      for (const { points, colour, line } of seen) {
        pen.beginPath();
        for (const [x, y, z] of points)
          pen.lineTo(size * (ct * y - st * x), -size * (cr * (z - 0.5 * tall) - sr * (ct * x + st * y)));
        pen.strokeStyle = line ?? colour;
        pen.lineWidth = line ? 2.5 : 1;
        if (!line) {
          pen.closePath();
          pen.fillStyle = colour;
          pen.fill();
        }
        pen.stroke();
      }
    },
  },
};
