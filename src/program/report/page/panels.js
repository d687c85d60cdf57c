// ---- what is closest, obstacles, and tables ----

function showReadout(frame) {
  const lines = [make('b', {}, clearanceWords(frame)), placeWords(frame), distanceWords(frame)];
  if (frame.between) lines.push(`${frame.between[0]} to ${frame.between[1]}`);
  element('readout').replaceChildren(...lines.filter((line) => line !== '').flatMap((line) => [line, make('br')]));
  element('slider').setAttribute('aria-valuetext', `${placeWords(frame)}: ${clearanceWords(frame)}`);
}

// The pose and the closest pair of a frame as rows of label and text; isExact: with all digits, for copying.
function closestRows(frame, isExact) {
  const pose = frame.pose.split(' ');
  const shown = (text) => isExact ? text : `(${pointText(text)})`;
  const rows = [];
  const side = (i, body) => {
    rows.push([`${body} mesh`, frame.between[i]]);
    rows.push([`${body} triangle`, `${frame.triangles[i]}, counted from 0 in its file`]);
    rows.push([`${frame.shrunk === body ? 'shrunk ' : ''}${body} point`, shown(frame.points[i])]);
  };
  if (frame.between) {
    side(0, 'part');
    side(1, 'obstacle');
    rows.push([frame.shrunk ? `distance, ${frame.shrunk} shrunk` : 'distance', isExact ? `${frame.distance}` : lengthText(frame.distance)]);
  }
  rows.push(['pose: translation', shown(pose.slice(0, 3).join(' '))]);
  rows.push(['quaternion x y z w', shown(pose.slice(3).join(' '))]);
  return rows;
}

const kFrameWords = 'Points and translation are in the environment\u2019s coordinates' + (data.unit ? `, in ${data.unit}` : '') +
  '. The pose takes the part\u2019s coordinates to the environment\u2019s. In its quaternion x y z w, w is last.';

function showClosest(frame) {
  const rows = closestRows(frame, false).flatMap(([label, text]) => [make('dt', {}, label), make('dd', {}, text)]);
  element('closest-rows').replaceChildren(...rows);
}

const closestText = (frame) => [`${placeWords(frame)}: ${clearanceWords(frame)}`,
  ...closestRows(frame, true).map(([label, text]) => `${label}: ${text}`), kFrameWords].join('\n');

// A page opened from a file may lack the clipboard; then the text is selected in a field and copied from there.
async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch (error) {
    const field = document.body.appendChild(make('textarea', { value: text }));
    field.select();
    document.execCommand('copy');
    field.remove();
  }
}

// The list of obstacles, the worst first. Obstacles whose clearance was not measured share one row.
class ObstacleList {
  constructor(view, choose) {
    this.view = view;
    this.choose = choose;
    const order = objects.map((object, i) => i);
    const listed = order.filter((i) => objects[i].clearance !== undefined)
      .sort((a, b) => objects[a].clearance - objects[b].clearance);
    const others = order.filter((i) => objects[i].clearance === undefined && objects[i].triangles > 0);
    this.rows = listed.map((i) => this.row([i], objects[i].name, this.clearanceButton(objects[i])));
    if (others.length) this.rows.push(this.row(others, this.otherWords(others, listed.length), this.otherBound(others)));
    element('obstacles').append(...this.rows.map((row) => row.line));
    element('obstacles-note').textContent = this.note(listed.length);
    element('all-obstacles').addEventListener('click', () => this.setHidden(order, false));
    element('no-obstacles').addEventListener('click', () => this.setHidden(order, true));
  }

  row(members, name, clearance) {
    const box = make('input', { type: 'checkbox', checked: true, disabled: !this.view });
    const label = make('label', { title: members.length === 1 ? name : '' }, box, ' ' + name);
    const line = make('tr', {}, make('td', {}, label), make('td', { className: 'number' }, clearance));
    box.addEventListener('input', () => this.setHidden(members, !box.checked));
    const pointOut = (index) => { if (this.view && members.length === 1) this.view.pointOut(index); };
    for (const type of ['pointerenter', 'focusin']) line.addEventListener(type, () => pointOut(members[0]));
    for (const type of ['pointerleave', 'focusout']) line.addEventListener(type, () => pointOut(-1));
    return { line, members, box };
  }

  clearanceButton(object) {
    const away = object.leftOut ? `, away from its contact at the ${object.leftOut}` : '';
    const words = (object.trouble || boundText(object.clearance)) + away;
    const button = make('button', { className: 'link', title: 'go there' }, words);
    if (object.trouble) button.prepend(make('span', { className: 'contact' }));
    button.addEventListener('click', () => this.choose(object.frame));
    return button;
  }

  otherWords(others, listed) {
    if (others.every((i) => objects[i].isIgnored)) return `${others.length} ignored`;
    const words = `${others.length}${listed ? ' other' : ''} obstacle${others.length === 1 ? '' : 's'}`;
    return words + (others.some((i) => objects[i].atLeast !== undefined) ? ', measured by their boxes' : ', which never count');
  }

  otherBound(others) {
    const bounds = others.map((i) => objects[i].atLeast).filter((bound) => bound !== undefined);
    return bounds.length ? `at least ${boundText(Math.max(0, Math.min(...bounds)))}` : '';
  }

  note(listed) {
    if (!listed) return '';
    const margin = data.measure === 'slack' ? 'see below' : data.margin > 0 ? 'distance less margin' : 'distance';
    return `Least ${data.measure} (${margin}) at the ${frames.length} places of the slider, a lower bound for each of them.` +
      (data.certified.length ? ' Between these places only the shaded profile is certified.' : '') +
      (listed < objects.length ? ` Listed are the ${listed} nearest of ${objects.length} obstacles.` : '');
  }

  setHidden(members, isHidden) {
    if (!this.view) return;
    const runs = this.view.wall.body.runs;
    for (const i of members) runs[i].isHidden = isHidden;
    for (const row of this.rows) {
      const hidden = row.members.filter((i) => runs[i].isHidden).length;
      row.box.checked = hidden < row.members.length;
      row.box.indeterminate = hidden > 0 && hidden < row.members.length;
    }
    this.view.showObstacles();
  }

  words(index) {
    const object = objects[index];
    if (object.clearance === undefined) return '';
    return object.trouble ? object.trouble + ' on the way' : `least ${data.measure} ${boundText(object.clearance)}`;
  }
}

// Names what is under the pointer once the pointer rests: looking for it takes some milliseconds.
class Pointer {
  constructor(view, list) {
    this.view = view;
    this.list = list;
    this.found = null;
    const canvas = view.renderer.domElement;
    canvas.addEventListener('pointermove', (event) => {
      this.forget();
      if (!event.buttons) this.timer = setTimeout(() => this.look(event.offsetX, event.offsetY), 40);
    });
    canvas.addEventListener('pointerleave', () => this.forget());
  }

  forget() {
    clearTimeout(this.timer);
    this.found = null;
    element('hover').hidden = true;
  }

  look(x, y) {
    this.found = this.view.at(x, y);
    const hover = element('hover'), { clientWidth, clientHeight } = this.view.container;
    hover.hidden = !this.found;
    if (!this.found) return;
    const words = this.found.object === undefined ? '' : this.list.words(this.found.object);
    hover.replaceChildren(make('b', {}, this.found.name), ...(words ? [make('br'), words] : []));
    hover.style.left = Math.min(x + 14, clientWidth - hover.offsetWidth - 6) + 'px';
    hover.style.top = Math.min(y + 14, clientHeight - hover.offsetHeight - 6) + 'px';
  }

  hideFound() {
    if (this.found?.object !== undefined) this.list.setHidden([this.found.object], true);
    this.forget();
  }
}

function tableOf(table, choose) {
  const isNumber = (text) => table.header.length && /^-?[\d.]+(e[-+]?\d+)?$/.test(text);
  const areNumbers = table.header.map((text, i) => table.rows.every((cells) => isNumber(cells[i]) || cells[i] === '-'));
  const align = (i) => ({ className: areNumbers[i] ? 'number' : '' });
  const made = make('table', { className: table.header.length ? '' : 'labels' });
  if (table.header.length) made.append(make('tr', {}, ...table.header.map((text, i) => make('th', align(i), text))));
  table.rows.forEach((cells, i) => {
    const row = make('tr', {}, ...cells.map((text, i) => make('td', align(i), text)));
    made.append(row);
    if (!table.frames) return;
    Object.assign(row, { className: 'jump', tabIndex: 0, title: 'show this place' });
    const go = () => choose(table.frames[i]);
    row.addEventListener('click', go);
    row.addEventListener('keydown', (event) => { if (event.key === 'Enter') go(); });
  });
  return made;
}

function fillTables(choose) {
  for (const table of data.tables) element('tables').append(make('h2', {}, table.title), tableOf(table, choose));
  element('verdict').textContent = data.verdict;
  element('note').textContent = data.note;
  element('closest-note').textContent = kFrameWords;
}
