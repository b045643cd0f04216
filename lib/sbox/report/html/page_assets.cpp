// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/report/html/page_assets.h"

namespace sbox::html {

// The colours are those of drawing/palette.h, lighter on dark ground.
const char* pageStyle() {
  return R"css(
:root {
  color-scheme: light;
  --paper: #ffffff; --ink: #262b33; --quiet: #5d6572; --frame: #d5d9de; --panel: #f5f6f8;
  --unknown: #ebeef1; --free: #ffffff; --wall: #484e55;
  --a: #0072b2; --b: #c97a00; --both: #1e2228; --conflict: #d0007f;
  --lines: #009e73; --points: #d55e00; --boxes: #0072b2;
  --accepted: #00694c; --ambiguous: #8a5a00; --rejected: #a8323e;
  --m0: #0072b2; --m1: #d55e00; --m2: #009e73; --m3: #b45aa7; --m4: #3caadc; --m5: #c88c00;
  --m6: #6a6a6a;
}
:root[data-theme="dark"] {
  color-scheme: dark;
  --paper: #16191d; --ink: #e4e7eb; --quiet: #9aa3af; --frame: #3a4048; --panel: #1e2227;
  --unknown: #22262c; --free: #343a42; --wall: #c3cad3;
  --a: #56b4e9; --b: #f0a830; --both: #f4f6f8; --conflict: #ff5fb4;
  --lines: #2fd3a5; --points: #ff8a4a; --boxes: #56b4e9;
  --accepted: #4bd6a8; --ambiguous: #f0b64a; --rejected: #ff8f98;
  --m0: #56b4e9; --m1: #ff8a4a; --m2: #2fd3a5; --m3: #e08fd3; --m4: #7fd0f5; --m5: #f0c24a;
  --m6: #b0b0b0;
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1180px; padding: 1.5rem; background: var(--paper);
  color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; margin: 0 0 .5rem; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .5rem; overflow-wrap: anywhere; }
h3 { font-size: 1rem; margin: 1.25rem 0 .5rem; }
p { max-width: 75ch; margin: .5rem 0; overflow-wrap: anywhere; }
ul { margin: .5rem 0; padding-left: 1.25rem; }
.table { overflow-x: auto; }
td.file { overflow-wrap: anywhere; min-width: 10rem; }
table { border-collapse: collapse; margin: .5rem 0; font-size: .9rem; }
th, td { padding: .3rem .8rem .3rem 0; border-bottom: 1px solid var(--frame); text-align: left;
  vertical-align: top; }
th { color: var(--quiet); font-weight: 600; }
.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
details { margin: .25rem 0 .75rem; color: var(--quiet); font-size: .9rem; }
summary { cursor: pointer; }
button { font: inherit; font-size: .85rem; color: var(--ink); background: var(--paper);
  border: 1px solid var(--frame); border-radius: 4px; padding: .1rem .6rem; cursor: pointer; }
#theme { float: right; }
.badge { display: inline-block; padding: 0 .6rem; border-radius: 1rem; border: 1px solid;
  font-weight: 600; font-size: .9rem; }
.accepted, .merged-all { color: var(--accepted); }
.ambiguous, .partly { color: var(--ambiguous); }
.rejected, .refused { color: var(--rejected); }
.controls { display: flex; flex-wrap: wrap; gap: .4rem 1.1rem; align-items: center;
  padding: .5rem .75rem; background: var(--panel); border: 1px solid var(--frame);
  border-radius: 6px 6px 0 0; border-bottom: 0; font-size: .9rem; }
.controls label { display: inline-flex; align-items: center; gap: .35rem; }
.controls .fade { flex-basis: 100%; }
.fade input { flex: 0 1 22rem; accent-color: var(--quiet); }
.zoom { margin-left: auto; display: inline-flex; gap: .25rem; }
.swatch { display: inline-block; width: .9rem; height: .9rem; border-radius: 3px;
  border: 1px solid var(--frame); }
.stage { position: relative; overflow: hidden; width: 100%; aspect-ratio: var(--ratio);
  background: var(--unknown); border: 1px solid var(--frame); touch-action: pan-y; cursor: grab; }
.viewer > .stage { max-width: calc(85vh * var(--ratio)); }
.viewer { --fade-a: 1; --fade-b: 1; }
.world { position: absolute; inset: 0; transform-origin: 0 0; }
.layer { position: absolute; inset: 0; }
div.layer { inset: auto; left: 0; bottom: 0; width: 100%; height: 100%;
  transform-origin: 0 100%; -webkit-mask-size: 100% 100%; mask-size: 100% 100%; }
.hidden { visibility: hidden; }
.free { background: var(--free); }
.wall { background: var(--wall); }
.free-a, .wall-a { background: var(--a); }
.free-b, .wall-b { background: var(--b); }
.layer.free-a { opacity: calc(.16 * var(--fade-a)); }
.layer.free-b { opacity: calc(.16 * var(--fade-b)); }
.layer.wall-a { opacity: var(--fade-a); }
.layer.wall-b { opacity: var(--fade-b); }
.wall-both { background: var(--both); }
.wall-conflict { background: var(--conflict); }
.layer.wall-both, .layer.wall-conflict { opacity: min(var(--fade-a), var(--fade-b)); }
.swatch.free-a { background: linear-gradient(135deg,
  color-mix(in srgb, var(--a) 25%, var(--paper)) 50%,
  color-mix(in srgb, var(--b) 25%, var(--paper)) 50%); }
div.layer.ring { width: 1.5rem; height: 1.5rem; bottom: auto; margin: -.75rem 0 0 -.75rem;
  border: 2px solid var(--conflict); border-radius: 50%;
  opacity: min(var(--fade-a), var(--fade-b)); }
.wall-0 { background: var(--m0); } .wall-1 { background: var(--m1); }
.wall-2 { background: var(--m2); } .wall-3 { background: var(--m3); }
.wall-4 { background: var(--m4); } .wall-5 { background: var(--m5); }
.wall-6 { background: var(--m6); }
svg { position: absolute; inset: 0; width: 100%; height: 100%; overflow: visible; }
path { fill: none; vector-effect: non-scaling-stroke; }
path.lines { stroke: var(--lines); stroke-width: 2px; }
path.points { stroke: var(--points); stroke-width: 7px; stroke-linecap: round; }
path.boxes { stroke: var(--boxes); stroke-width: 1px; stroke-opacity: .35; fill: var(--boxes);
  fill-opacity: .08; }
.swatch.lines { background: var(--lines); }
.swatch.points { background: var(--points); border-radius: 50%; }
.swatch.boxes { background: color-mix(in srgb, var(--boxes) 25%, var(--paper)); }
.scale { position: absolute; left: 1rem; bottom: .75rem; height: .45rem; border: 2px solid
  var(--ink); border-top: 0; font-size: .8rem; line-height: 1; text-align: center;
  pointer-events: none; padding: 0; }
.scale { display: flex; align-items: flex-end; justify-content: center; padding-bottom: .35rem; }
.alternatives { display: grid; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr));
  gap: 1rem; }
figure { margin: 0; }
figcaption { font-size: .9rem; color: var(--quiet); margin-top: .25rem; }
footer { margin-top: 3rem; color: var(--quiet); font-size: .9rem; }
@media print { .controls, button { display: none; } }
)css";
}

const char* pageScript() {
  return R"js(
'use strict';
const root = document.documentElement;
const wantsDark = window.matchMedia('(prefers-color-scheme: dark)');
const setTheme = (dark) => { root.dataset.theme = dark ? 'dark' : 'light'; };
setTheme(wantsDark.matches);
wantsDark.addEventListener('change', (event) => setTheme(event.matches));

document.addEventListener('DOMContentLoaded', () => {
  const theme = document.getElementById('theme');
  theme.hidden = false;
  theme.addEventListener('click', () => setTheme(root.dataset.theme !== 'dark'));
  document.querySelectorAll('.viewer').forEach(setUpViewer);
});

function setUpViewer(viewer) {
  const fade = viewer.querySelector('[data-fade]');
  const boxes = [...viewer.querySelectorAll('[data-toggles]')];
  const showLayers = () => {
    const hidden = new Set(boxes.filter((box) => !box.checked).map((box) => box.dataset.toggles));
    for (const layer of viewer.querySelectorAll('.layer')) {
      const names = layer.dataset.layer.split(' ');
      // "a free" goes with map a and with free space; "map 3" is one name.
      layer.classList.toggle('hidden', hidden.has(layer.dataset.layer) ||
          (names[1] === 'free' && names.some((name) => hidden.has(name))));
    }
  };
  boxes.forEach((box) => box.addEventListener('change', showLayers));
  showLayers();
  if (fade) {
    const showFade = () => {
      const share = fade.value / 100;
      viewer.style.setProperty('--fade-a', Math.min(1, 2 * (1 - share)));
      viewer.style.setProperty('--fade-b', Math.min(1, 2 * share));
    };
    fade.addEventListener('input', showFade);
    showFade();
  }
  viewer.querySelectorAll('.stage').forEach((stage) => setUpStage(viewer, stage));
}

function setUpStage(viewer, stage) {
  const world = stage.querySelector('.world');
  let scale = 1, x = 0, y = 0, drag = null;
  const show = () => {
    x = Math.min(0, Math.max(stage.clientWidth * (1 - scale), x));
    y = Math.min(0, Math.max(stage.clientHeight * (1 - scale), y));
    world.style.transform = `translate(${x}px, ${y}px) scale(${scale})`;
  };
  const zoom = (factor, cx, cy) => {
    const next = Math.min(40, Math.max(1, scale * factor));
    x = cx - (cx - x) * next / scale;
    y = cy - (cy - y) * next / scale;
    scale = next;
    show();
  };
  const middle = (factor) => zoom(factor, stage.clientWidth / 2, stage.clientHeight / 2);
  const actions = { in: () => middle(1.5), out: () => middle(1 / 1.5), reset: () => middle(0) };
  viewer.querySelectorAll('[data-zoom]').forEach((button) =>
      button.addEventListener('click', actions[button.dataset.zoom]));
  stage.addEventListener('wheel', (event) => {
    if (event.ctrlKey) {
      event.preventDefault();
      const box = stage.getBoundingClientRect();
      zoom(Math.exp(-event.deltaY / 300), event.clientX - box.left, event.clientY - box.top);
    }
  }, { passive: false });
  stage.addEventListener('pointerdown', (event) => {
    drag = { x: event.clientX - x, y: event.clientY - y };
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener('pointermove', (event) => {
    if (drag) {
      x = event.clientX - drag.x;
      y = event.clientY - drag.y;
      show();
    }
  });
  for (const end of ['pointerup', 'pointercancel']) {
    stage.addEventListener(end, () => { drag = null; });
  }
}
)js";
}

}  // namespace sbox::html
