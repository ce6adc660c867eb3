// A closer look at the pictures: drag over one, double-click to see all of it; + - arrows and 0 by keyboard.
'use strict';
const minus = text => text.replace('-', '\u2212');
// Round values between two ends with their texts; ends of a logarithmic axis are powers of ten.
function marks(low, high, isLog, about) {
  if (isLog && high - low > 1.5) {
    const step = Math.max(1, Math.ceil((high - low) / about)), all = [];
    for (let k = Math.ceil(low - 1e-9); k <= high + 1e-9; k++) if (k % step === 0) all.push([k, k < -3 || k > 4 ? minus('1e' + k) : String(+(10 ** k).toPrecision(1)), 10 ** k]);
    return all;
  }
  const [from, to] = isLog ? [10 ** low, 10 ** high] : [low, high];
  const raw = (to - from) / about, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= 0.999 * raw), all = [];
  for (let k = Math.ceil(from / step - 1e-9); k <= Math.floor(to / step + 1e-9); k++) {
    const value = k * step, size = Math.max(Math.abs(value), step);
    const digits = Math.max(0, Math.floor(Math.log10(size)) - Math.floor(Math.log10(step)));
    const decimals = Math.min(9, Math.max(0, -Math.floor(Math.log10(step))));
    const text = size >= 1e-4 && size < 1e6 ? value.toFixed(decimals) : value === 0 ? '0' : value.toExponential(Math.min(digits, 6));
    all.push([isLog ? Math.log10(value) : value, minus(text), value]);
  }
  return all;
}
function closer(svg) {
  const axis = name => { const [low, high, from, to, log] = svg.dataset[name].split(' ').map(Number); return { low, high, from, to, log }; };
  const X = axis('x'), Y = axis('y'), beside = +svg.dataset.beside;
  const plots = svg.querySelectorAll('.plot'), ticks = svg.querySelector('.ticks'), drawn = ticks.innerHTML;
  const all = [X.from, Y.to, X.to, Y.from];
  let view = all, start = null, pick = null;
  const part = (a, p, q) => { const at = p => a.low + (p - a.from) / (a.to - a.from) * (a.high - a.low); return [at(p), at(q)]; };
  const axes = () => {
    let text = '';
    const [bottom, top] = part(Y, view[3], view[1]), [left, right] = part(X, view[0], view[2]);
    for (const [at, words] of marks(bottom, top, Y.log, 5)) {
      const y = Y.from + (at - bottom) / (top - bottom) * (Y.to - Y.from);
      text += `<path class="grid" d="M${X.from} ${y}H${X.to}"/><text x="${X.from - 6}" y="${y + 5}" text-anchor="end">${words}</text>`;
    }
    for (const [at, words, value] of marks(left, right, X.log, beside ? 4 : 6)) {
      const x = X.from + (at - left) / (right - left) * (X.to - X.from);
      const other = beside ? ` (${minus(String(+(beside * value).toPrecision(3)))})` : '';
      text += `<path class="tick" d="M${x} ${Y.from}v5"/><text x="${x}" y="${Y.from + 20}" text-anchor="middle">${words}${other}</text>`;
    }
    return text;
  };
  const show = wanted => {
    const width = Math.min(wanted[2] - wanted[0], all[2] - all[0]), height = Math.min(wanted[3] - wanted[1], all[3] - all[1]);
    const x = Math.max(all[0], Math.min(wanted[0], all[2] - width)), y = Math.max(all[1], Math.min(wanted[1], all[3] - height));
    if (width < 0.05 || height < 0.05) return;
    view = [x, y, x + width, y + height];
    const isWhole = view.every((v, i) => v === all[i]);
    plots.forEach(p => p.setAttribute('viewBox', `${x} ${y} ${width} ${height}`));
    ticks.innerHTML = isWhole ? drawn : axes();
  };
  const scaled = (by, shift) => {
    const middle = 0.5 * (view[0] + view[2]), half = 0.5 * by * (view[2] - view[0]), move = shift * (view[2] - view[0]);
    show([middle - half + move, view[1], middle + half + move, view[3]]);
  };
  const place = e => {
    const box = svg.getBoundingClientRect(), by = svg.viewBox.baseVal.width / box.width;
    const inside = (v, a, b) => Math.min(Math.max(v, Math.min(a, b)), Math.max(a, b));
    return [inside((e.clientX - box.left) * by, X.from, X.to), inside((e.clientY - box.top) * by, Y.to, Y.from)];
  };
  const picked = e => { const [x, y] = place(e); return [Math.min(x, start[0]), Math.min(y, start[1]), Math.max(x, start[0]), Math.max(y, start[1])]; };
  const end = () => { start = null; if (pick) pick.remove(); pick = null; };
  svg.addEventListener('pointerdown', e => { if (e.button === 0 && e.pointerType !== 'touch') { e.preventDefault(); start = place(e); svg.setPointerCapture(e.pointerId); svg.focus(); } });
  svg.addEventListener('pointermove', e => {
    if (!start) return;
    if (!pick) { pick = document.createElementNS(svg.namespaceURI, 'rect'); pick.setAttribute('class', 'pick'); svg.append(pick); }
    const [x, y, right, bottom] = picked(e);
    Object.entries({ x, y, width: right - x, height: bottom - y }).forEach(([name, value]) => pick.setAttribute(name, value));
  });
  svg.addEventListener('pointerup', e => {
    if (!start) return;
    const [x, y, right, bottom] = picked(e);
    end();
    if (right - x < 8) return;
    // a flat drag looks closer along x alone
    const of = (p, a, from, to) => view[a] + (p - from) / (to - from) * (view[a + 2] - view[a]);
    const tall = bottom - y >= 16;
    show([of(x, 0, X.from, X.to), tall ? of(y, 1, Y.to, Y.from) : view[1], of(right, 0, X.from, X.to), tall ? of(bottom, 1, Y.to, Y.from) : view[3]]);
  });
  svg.addEventListener('pointercancel', end);
  svg.addEventListener('dblclick', () => show(all));
  svg.setAttribute('tabindex', '0');
  svg.addEventListener('keydown', e => {
    const act = { '+': () => scaled(0.5, 0), '=': () => scaled(0.5, 0), '-': () => scaled(2, 0), ArrowLeft: () => scaled(1, -0.25), ArrowRight: () => scaled(1, 0.25), 0: () => show(all), Escape: () => show(all) }[e.key];
    if (act && !e.ctrlKey && !e.metaKey && !e.altKey) { e.preventDefault(); act(); }
  });
}
const pictures = document.querySelectorAll('svg[data-x]');
pictures.forEach(closer);
const hint = document.getElementById('closer');
if (hint && pictures.length) hint.textContent = 'Drag over a picture to look closer, double-click to see all of it; or click and type + \u2212 \u2190 \u2192 0.';
