// What the browser does around the program: it starts it, hands events to it as a window system does, and says what is wrong.
'use strict';
const canvas = document.getElementById('canvas');
const bar = document.getElementById('bar');
const said = document.getElementById('said');
let lab = null;

function say(text) {
  said.textContent = text;
}

// ---- start: unpacked, compiled, then the first frame. The page goes on drawing in between.

function missing() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 'This browser has no WebGL 2, or it is switched off.';
  const floats = gl.getExtension('EXT_color_buffer_float');
  const lose = gl.getExtension('WEBGL_lose_context');
  if (lose) lose.loseContext();
  if (!floats) return 'WebGL 2 cannot draw into textures of floats here (EXT_color_buffer_float).';
  if (!window.DecompressionStream) return 'This browser is too old: it cannot take apart compressed data (DecompressionStream).';
  return '';
}

async function codeOfPage() {
  const text = document.getElementById('code').textContent;
  const packed = await (await fetch('data:application/octet-stream;base64,' + text)).blob();
  return new Response(packed.stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

function frameOf(stage) {
  bar.value = stage;
  performance.mark('stage ' + stage);
  return new Promise(done => setTimeout(done));
}

async function start() {
  const lacking = missing();
  if (lacking) {
    bar.hidden = true;
    say(lacking + '\nIt needs what Chrome or Edge 95, Firefox 113 and Safari 16.4 brought; else the lab is a program of its own, too.');
    return;
  }
  await frameOf(1);
  const code = await codeOfPage();
  await frameOf(2);
  const asked = stateOfLink();
  lab = await makeLab({
    canvas,
    wasmBinary: code,
    download, copy, showInAddress, tell, frameDrawn,
    print: line => console.log(line),
    printErr: line => { console.warn(line); say(line); },
    preRun: [m => { if (asked) m.FS.writeFile('/link.json', asked); }],
    noInitialRun: true,
  });
  await frameOf(3);
  lab.callMain([]);
  openExercises();
  mouse('mousemove', -1, -1);  // nobody points at anything yet
}

// A browser may take the device back. What is shown goes on with the next one, from its settings.
canvas.addEventListener('webglcontextlost', e => {
  e.preventDefault();
  if (!lab) return;
  lab.pauseMainLoop();
  say('The browser has taken the graphics device back; the lab goes on when it gives one.');
});

canvas.addEventListener('webglcontextrestored', () => {
  if (!lab) return;
  say('');
  if (shown) lab.FS.writeFile('/link.json', shown);
  lab.ccall('page_begin', null, [], []);
});

// The program calls this after each frame.
function frameDrawn() {
  if (!bar.hidden) performance.mark('first frame');
  bar.hidden = true;
  document.body.dataset.frames = 1 + Number(document.body.dataset.frames || 0);
}

// ---- the address: behind # stands what is shown, as in the pictures that F12 saves

let written = '';  // the last that was put there
let shown = '';    // … as JSON

function stateOfLink() {
  const text = location.hash.slice(1);
  if (!text) return '';
  try {
    return decodeURIComponent(text);
  } catch (e) {
    return text;  // and the program says what is wrong with it
  }
}

// What is beside the picture stays in the address.
function queryWith(lesson) {
  const kept = new URLSearchParams();
  for (const [name, value] of new URLSearchParams(location.search))
    if (name === 'present' || name === 'exercise') kept.append(name, value);
  if (lesson) kept.append('lesson', lesson);
  return '?' + kept === '?' ? '' : '?' + String(kept).replace(/%3A/g, ':');
}

// lesson: "NAME:3", its third step; '': none is open.
function showInAddress(state, lesson) {
  shown = state;
  written = '#' + encodeURIComponent(state).replace(/%(2C|3A|7B|7D|5B|5D|2F)/g, decodeURIComponent);
  history.replaceState(null, '', location.pathname + queryWith(lesson) + written);
}

addEventListener('hashchange', () => {
  if (lab && location.hash !== written && stateOfLink()) give('/link.json', new TextEncoder().encode(stateOfLink()));
});

// ---- files

const kLargestDrop = 256 << 20;  // bytes; a page has at most 2 GB for everything

function give(path, bytes) {
  lab.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')) || '/');
  lab.FS.writeFile(path, bytes);
  open(path);
}

function open(path) {
  lab.ccall('page_open', null, ['string'], [path]);
}

// Of a folder all files, with their places in it.
async function filesOf(entry, folder) {
  if (entry.isFile) return [[folder + entry.name, await new Promise((done, no) => entry.file(done, no))]];
  const reader = entry.createReader();
  const all = [];
  for (;;) {
    const some = await new Promise((done, no) => reader.readEntries(done, no));
    if (some.length === 0) return all;
    for (const e of some) all.push(...await filesOf(e, folder + entry.name + '/'));
  }
}

let drops = 0;

// A folder is a model with what belongs to it.
async function take(files) {
  const bytes = files.reduce((sum, [, file]) => sum + file.size, 0);
  if (bytes > kLargestDrop) {
    say(files[0][0] + ': ' + Math.ceil(bytes / 1048576) + ' MB are too large for a page; it takes ' + kLargestDrop / 1048576 +
        ' MB, the program on a desktop more');
    return;
  }
  const place = '/dropped' + ++drops + '/';
  const known = files.map(f => f[0]).filter(name => /\.(gltf|glb)$/i.test(name));
  const one = files.length === 1 ? files[0][0] : known.length === 1 ? known[0] : '';
  if (!one) {
    say(files.length + ' files with ' + known.length + ' models at once: drop one, or one folder of one model');
    return;
  }
  for (const [name, file] of files) {
    const path = place + name;
    lab.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    lab.FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
  }
  open(place + one);
}

addEventListener('dragover', e => e.preventDefault());
addEventListener('drop', async e => {
  e.preventDefault();
  e.stopImmediatePropagation();
  if (!lab) return;
  // Both are asked at once: the list is empty later. Of single files no entry: a page that is itself a file may not read it.
  const items = [...e.dataTransfer.items].filter(i => i.kind === 'file').map(i => [i.webkitGetAsEntry(), i.getAsFile()]);
  try {
    const files = [];
    for (const [entry, file] of items)
      if (entry && entry.isDirectory) files.push(...await filesOf(entry, ''));
      else files.push([file.name, file]);
    if (files.length) await take(files);
  } catch (error) {
    say('This browser lets the page read no folder (' + error.name + '). Drop all files of the model together instead.');
  }
}, true);

function copy(text) {
  const refused = () => say('The browser lets this page copy nothing. The text:\n' + text);
  if (navigator.clipboard) navigator.clipboard.writeText(text).catch(refused);
  else refused();
}

function download(path) {
  lab.FS.ignorePermissions = true;  // its files are written for their owner alone
  const bytes = lab.FS.readFile(path);
  lab.FS.ignorePermissions = false;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = path.split('/').pop();
  document.body.dataset.saved = link.download;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

// ---- keys: the canvas takes them while it has the focus. Shift and Tab leave it, F5 reads the page again.

function isOurs(e) {
  const left = e.altKey || e.metaKey || e.key === 'F5' || (e.key === 'Tab' && e.shiftKey);
  return document.activeElement === canvas && !left;
}

for (const kind of ['keydown', 'keypress', 'keyup'])
  addEventListener(kind, e => {
    if (!isOurs(e) && kind !== 'keyup') {
      e.stopImmediatePropagation();
      return;
    }
    said.textContent = '';
    // A character is typed by what follows the key; that must come.
    if (kind === 'keypress' || e.key.length > 1 || e.ctrlKey) e.preventDefault();
  }, true);

canvas.addEventListener('pointerdown', () => { canvas.focus(); said.textContent = ''; });

// ---- mouse and touch: what a finger does is done by the mouse, two are the wheel

function mouse(kind, x, y) {
  canvas.dispatchEvent(new MouseEvent(kind, {clientX: x, clientY: y, button: 0, bubbles: true}));
}

function turn(notches, sideways, x, y, shift) {
  canvas.dispatchEvent(new WheelEvent('wheel', {deltaX: sideways, deltaY: notches, clientX: x, clientY: y, shiftKey: shift}));
}

const kNotch = [100, 3, 1];  // of a wheel: pixels, lines, pages

addEventListener('wheel', e => {
  if (!e.isTrusted || e.target !== canvas) return;
  e.preventDefault();
  e.stopImmediatePropagation();
  turn(e.deltaY / kNotch[e.deltaMode], e.deltaX / kNotch[e.deltaMode], e.clientX, e.clientY, e.shiftKey);
}, {capture: true, passive: false});

const kPinchPerNotch = 1.15;  // how much farther apart two fingers are for one notch
let pinch = 0;                // their distance; 0: there are not two
let finger = false;           // one is down as the mouse's button

function touched(e) {
  e.preventDefault();
  e.stopImmediatePropagation();
  const at = [...e.touches];
  if (at.length === 2) {
    const distance = Math.hypot(at[0].clientX - at[1].clientX, at[0].clientY - at[1].clientY);
    const x = (at[0].clientX + at[1].clientX) / 2, y = (at[0].clientY + at[1].clientY) / 2;
    if (finger) mouse('mouseup', x, y);
    finger = false;
    if (pinch > 0) turn(-Math.log(distance / pinch) / Math.log(kPinchPerNotch), 0, x, y, false);
    mouse('mousemove', x, y);
    pinch = distance;
    return;
  }
  const was = pinch > 0;
  pinch = 0;
  if (at.length === 1 && !was) {
    mouse('mousemove', at[0].clientX, at[0].clientY);
    if (e.type === 'touchstart') {
      canvas.focus();
      mouse('mousedown', at[0].clientX, at[0].clientY);
      finger = true;
    }
  }
  if (at.length === 0 && finger) {
    const last = e.changedTouches[0];
    mouse('mouseup', last.clientX, last.clientY);
    finger = false;
  }
}

for (const kind of ['touchstart', 'touchmove', 'touchend', 'touchcancel'])
  canvas.addEventListener(kind, touched, {capture: true, passive: false});

// ---- what is seen, in words, for those who do not see it

function tell(text) {
  const words = document.getElementById('words');
  if (words.textContent !== text) words.textContent = text;
}

start();
