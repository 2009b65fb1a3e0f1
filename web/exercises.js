// Exercises: the task, a place for the answer, and whether it is right. What is written there is the answer's file of the desktop.
'use strict';
const exercise = {
  panel: document.getElementById('exercise'),
  which: document.getElementById('which'),
  answer: document.getElementById('answer'),
  verdict: document.getElementById('verdict'),
  task: null,
};

function askLab(name, ...words) {
  return JSON.parse(lab.ccall(name, 'string', words.map(() => 'string'), words));
}

function button(text, work) {
  const b = document.createElement('button');
  b.textContent = text;
  b.onclick = work;
  return b;
}

// The page's picture has a size of its own.
function takePixel(task) {
  const [x, y, ...size] = lab.ccall('page_pixel', 'string', [], []).split(' ').map(Number);
  if (!size.length) {
    exercise.verdict.textContent = 'no pixel is held: click on one in the picture';
    return;
  }
  const pixel = [x, y].map((at, i) => Math.floor((at + 0.5) * task.size[i] / size[i]));
  exercise.answer.value = JSON.stringify({exercise: task.id, answer: pixel}) + '\n';
}

// Some answers need no typing.
function helpers(task) {
  const out = task.choices.map(c => button(c.id + ': ' + c.text,
      () => { exercise.answer.value = JSON.stringify({exercise: task.id, answer: c.id}, null, 2) + '\n'; }));
  if (task.kind === 'pixel') out.push(button('take the held pixel', () => takePixel(task)));
  if (task.kind === 'settings') out.push(button('take what is shown', () => { exercise.answer.value = shown || task.state; }));
  return out;
}

function showExercise(id) {
  const task = askLab('page_task', id);
  if (task.error) {
    say('gbufferlab: ' + task.error);
    return false;
  }
  exercise.task = task;
  exercise.which.value = id;
  document.getElementById('task').textContent = task.task;
  document.getElementById('source').textContent = 'from: ' + task.source;
  const pixel = task.kind === 'pixel' ? ' The picture has ' + task.size.join(' x ') + ' pixels.' : '';
  document.getElementById('how').textContent = task.how + pixel;
  document.getElementById('holds').textContent = task.holds && 'A right answer holds:\n' + task.holds.replace(/ +/g, ' ') + task.tolerance;
  document.getElementById('helpers').replaceChildren(...helpers(task));
  exercise.answer.value = task.begin;
  exercise.answer.rows = Math.min(16, task.begin.split('\n').length + 1);
  exercise.verdict.textContent = '';
  return true;
}

// Another one: the picture is then its state, and the address names it.
function chooseExercise(id) {
  if (!showExercise(id)) return;
  history.replaceState(null, '', '?exercise=' + id);
  give('/' + id + '.json', new TextEncoder().encode(exercise.task.state));
}

// Nothing is drawn meanwhile, so that is said first. A shader that never ends has the browser take the device back.
function checkAnswer() {
  const {task, verdict} = exercise;
  verdict.textContent = 'checking …';
  setTimeout(() => {
    const file = '/answers/' + task.file;
    lab.FS.mkdirTree('/answers');
    lab.FS.writeFile(file, exercise.answer.value);
    const v = askLab('page_judge', task.id, file);
    const lost = canvas.getContext('webgl2').isContextLost();
    const lines = v.error ? [v.error] : lost ? ['wrong', 'it did not end: the browser has taken the graphics device back'] :
        [v.right ? 'right' : 'wrong', v.measured && 'measured: ' + v.measured, v.off && 'off: ' + v.off, v.hint && 'hint: ' + v.hint];
    verdict.textContent = lines.filter(line => line).join('\n');
    verdict.scrollIntoView({block: 'nearest'});
  }, 50);
}

// ?exercise=NAME, or ?exercise alone for the first.
function openExercises() {
  const asked = new URLSearchParams(location.search).get('exercise');
  if (asked === null) return;
  const all = askLab('page_exercises');
  if (all.error) return say('gbufferlab: ' + all.error);
  exercise.which.replaceChildren(...all.map(e => new Option(e.title, e.id)));
  if (!asked) chooseExercise(all[0].id);
  else if (!showExercise(asked)) return;
  exercise.which.onchange = () => chooseExercise(exercise.which.value);
  document.getElementById('check').onclick = checkAnswer;
  exercise.panel.hidden = false;
  dispatchEvent(new Event('resize'));  // the picture has less room now
}
