// ---- the clearance profile, and the scale of its colours ----

class Profile {
  constructor(canvas, choose) {
    this.canvas = canvas;
    this.isLogarithmic = false;
    const chooseAt = (event) => choose(this.frameAt(event.clientX - canvas.getBoundingClientRect().left));
    canvas.addEventListener('pointerdown', (event) => { canvas.setPointerCapture(event.pointerId); chooseAt(event); });
    canvas.addEventListener('pointermove', (event) => { if (event.buttons) chooseAt(event); });
    new ResizeObserver(() => this.fit()).observe(canvas);
    this.fit();
  }

  fit() {
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    this.plot = { left: 58, right: this.width - 12, top: 14, bottom: this.height - 18 };
    this.range = this.findRange();
    element('profile-title').textContent = this.title;
    this.still = document.createElement('canvas');
    this.drawStill(contextOf(this.still, this.width, this.height));
    this.show(state.frame);
  }

  setLogarithmic(isLogarithmic) {
    this.isLogarithmic = isLogarithmic;
    this.fit();
  }

  // The clearances at the bottom and the top. Linear, the top is that of the colours, so that tight places can be
  // told apart; logarithmic, both hold all clearances, over at most six powers of ten.
  findRange() {
    if (!this.isLogarithmic) return [0, data.scaleMost];
    const most = data.most > 0 ? data.most : 1;
    const positive = frames.map((frame) => frame.clearance).filter((clearance) => clearance > 0);
    const least = Math.min(most / 10, ...positive, ...data.certified.filter((clearance) => clearance > 0));
    return [Math.max(least / 1.5, most * 1e-6), most * 1.1];
  }

  x(share) { return this.plot.left + share * (this.plot.right - this.plot.left); }

  y(clearance) {
    const [low, high] = this.range;
    const value = Math.min(high, Math.max(low, clearance === null ? Infinity : clearance));
    const share = this.isLogarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
    return this.plot.bottom - share * (this.plot.bottom - this.plot.top);
  }

  isCut(frame) { return !frame.trouble && !frame.isFree && (frame.clearance === null || frame.clearance > this.range[1] * (1 + 1e-6)); }

  frameAt(x) {
    const share = (x - this.plot.left) / (this.plot.right - this.plot.left);
    let best = 0;
    frames.forEach((frame, i) => { if (Math.abs(frame.share - share) < Math.abs(frames[best].share - share)) best = i; });
    return best;
  }

  ticks() {
    const [low, high] = this.range;
    if (!this.isLogarithmic) return [0, 1, 2, 3, 4].map((i) => high * i / 4);
    const powers = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power) powers.push(10 ** power);
    const multiples = powers.length > 3 ? [1] : [1, 2, 5];
    return powers.flatMap((power) => multiples.map((m) => m * power)).filter((tick) => tick >= low && tick <= high);
  }

  get title() {
    const parts = [`${data.measure}${data.unit ? ' in ' + data.unit : ''} along the way`];
    if (data.certified.length) parts.push('shaded: certified between poses');
    if (frames.some((frame) => this.isCut(frame))) parts.push(`\u25b2 above ${lengthText(this.range[1])}: cut off`);
    return parts.join(' \u00b7 ');
  }

  drawStill(context) {
    const { left, right, top, bottom } = this.plot;
    context.fillStyle = styleColour('muted');
    context.strokeStyle = styleColour('rule');
    context.textAlign = 'right';
    for (const tick of this.ticks()) {
      const y = this.y(tick);
      context.beginPath(); context.moveTo(left, y); context.lineTo(right, y); context.stroke();
      context.fillText(digits(tick), left - 6, y + 4);
    }
    for (const percent of [0, 25, 50, 75, 100]) {
      context.textAlign = percent === 100 ? 'right' : 'center';
      context.fillText(percent + ' %', this.x(percent / 100), bottom + 14);
    }
    this.drawCertified(context);
    this.drawTrouble(context);
    this.drawCurve(context);
    this.drawCuts(context);
  }

  drawCertified(context) {
    const count = data.certified.length;
    context.fillStyle = styleColour('certified');
    data.certified.forEach((clearance, i) => {
      if (!(clearance > 0)) return;
      const y = this.y(clearance);
      context.fillRect(this.x(i / count), y, this.x((i + 1) / count) - this.x(i / count) + 0.3, this.plot.bottom - y);
    });
  }

  // The stretch of the plot that belongs to a frame: halfway to its neighbours.
  stretch(i) {
    const middle = (a, b) => this.x((frames[a].share + frames[b].share) / 2);
    return [middle(Math.max(0, i - 1), i), middle(i, Math.min(frames.length - 1, i + 1))];
  }

  drawTrouble(context) {
    const { top, bottom } = this.plot;
    frames.forEach((frame, i) => {
      if (!frame.trouble) return;
      const [from, to] = this.stretch(i);
      context.globalAlpha = 0.25;
      context.fillStyle = kContact;
      context.fillRect(from, top, Math.max(1, to - from), bottom - top);
      context.globalAlpha = 1;
      fillContact(context, from, bottom - 8, Math.max(2, to - from), 8);
    });
  }

  drawCurve(context) {
    // In contact the hatching at the bottom is the line.
    const segments = frames.slice(1).map((frame, i) => [frames[i], frame]).filter(([a, b]) => !a.trouble || !b.trouble);
    const draw = ([a, b], width, colour) => {
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.beginPath();
      context.moveTo(this.x(a.share), this.y(a.clearance));
      context.lineTo(this.x(b.share), this.y(b.clearance));
      context.stroke();
    };
    // The darker line below keeps the light end of the scale readable on white, and the lighter one the dark end.
    const casing = styleColour('casing');
    for (const segment of segments) draw(segment, 4.5, casing);
    for (const [a, b] of segments) {
      const worse = a.trouble || (!b.trouble && (a.clearance ?? Infinity) < (b.clearance ?? Infinity)) ? a : b;
      draw([a, b], 2.5, `rgb(${frameColour(worse)})`);
    }
  }

  drawCuts(context) {
    context.fillStyle = styleColour('ink');
    let last = -Infinity;
    frames.forEach((frame) => {
      const x = this.x(frame.share), y = this.plot.top - 4;
      if (!this.isCut(frame) || x < last + 12) return;
      last = x;
      context.beginPath(); context.moveTo(x - 4, y); context.lineTo(x, y - 7); context.lineTo(x + 4, y); context.fill();
    });
  }

  show(i) {
    const context = contextOf(this.canvas, this.width, this.height);
    context.drawImage(this.still, 0, 0, this.width, this.height);
    const x = this.x(frames[i].share);
    context.strokeStyle = styleColour('ink');
    context.beginPath(); context.moveTo(x, this.plot.top - 4); context.lineTo(x, this.plot.bottom); context.stroke();
    context.fillStyle = styleColour('mark');
    context.beginPath(); context.arc(x, this.y(frames[i].clearance), 4.5, 0, 7); context.fill();
  }
}

// The scale of the part's colours. Below it the colour of contact, which the scale does not hold.
function drawScale(context, width, height) {
  const top = 38, bottom = height - 36;
  context.fillStyle = styleColour('panel');
  context.fillRect(0, 0, width, height);
  for (let y = top; y < bottom; ++y) {
    context.fillStyle = `rgb(${scaleColour(data.scaleMost * (bottom - y) / (bottom - top))})`;
    context.fillRect(8, y, 14, 1.5);
  }
  fillContact(context, 8, bottom + 14, 14, 14);
  context.fillStyle = styleColour('ink');
  context.fillText(data.measure, 8, 14);
  if (data.unit) context.fillText(`in ${data.unit}`, 8, 27);
  const isOpen = data.most > data.scaleMost * (1 + 1e-6);
  for (let i = 0; i <= 4; ++i) {
    const text = (i === 4 && isOpen ? '\u2265 ' : i === 0 ? '> ' : '') + digits(data.scaleMost * i / 4);
    context.fillText(text, 27, bottom + (top - bottom) * i / 4 + 4);
  }
  context.fillText('in contact', 27, bottom + 20);
  context.fillText(data.margin > 0 ? 'or too close' : data.measure === 'slack' ? 'or too deep' : '', 27, bottom + 32);
}
