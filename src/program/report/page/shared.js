// The report page: a 3D view, a slider along the path, the clearance profile, obstacles, figures and tables.
// Coordinates are those of the environment minus the middle of its box, so that floats represent them well.
import * as THREE from 'three';
import { OrbitControls } from 'orbit-controls';

const element = (id) => document.getElementById(id);
const data = JSON.parse(element('data').textContent);
const frames = data.frames;
const objects = data.environment.objects;
const state = { frame: 0, isPlaying: false };
const lessMotion = window.matchMedia('(prefers-reduced-motion: reduce)');

// ---- numbers ----

const digits = (value) => Number(value.toPrecision(4)).toString();
const withUnit = (text) => data.unit ? `${text}\u00a0${data.unit}` : text;
const lengthText = (value) => withUnit(digits(value));

// Rounds towards zero, so that a lower bound is never rounded up. Bounds are stored as floats, hence the small share.
function boundText(value) {
  if (!value) return withUnit('0');
  const unit = 10 ** (Math.floor(Math.log10(Math.abs(value))) - 3);
  return lengthText(Math.trunc(value / unit * (1 + 1e-7)) * unit);
}

// Coordinates for reading: rounding errors of a zero are shown as 0.
function pointText(text) {
  const noise = 1e-9 * Math.max(1, data.radius);
  return text.split(' ').map((number) => digits(Math.abs(number) < noise ? 0 : Number(number))).join(', ');
}

// ---- the way ----

const kPlaySeconds = 12, kDegreesPerSecond = 180;

function degreesBetween(p, q) {
  const chord = (sign) => Math.hypot(...p.map((value, i) => value - sign * q[i]));
  return 720 / Math.PI * Math.asin(Math.min(1, chord(1) / 2, chord(-1) / 2));
}

// Each frame's degrees turned since the start, and its time when the path is played: at an even pace, but slower where
// the part would turn faster than the eye can follow.
frames.forEach((frame, i) => {
  const last = frames[i - 1] ?? { ...frame, turned: 0, time: 0 };
  const degrees = degreesBetween(last.rotation, frame.rotation);
  frame.turned = last.turned + degrees;
  frame.time = last.time + Math.max(kPlaySeconds * (frame.share - last.share), degrees / kDegreesPerSecond);
});

// ---- elements ----

// Makes an element with properties and children, which are elements or texts.
function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// Sizes a canvas for the screen's pixels and returns its context, which draws in CSS pixels.
function contextOf(canvas, width, height) {
  const ratio = window.devicePixelRatio;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext('2d');
  context.scale(ratio, ratio);
  context.font = '11px system-ui, sans-serif';
  return context;
}

// ---- colours ----

const styleColour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
const kContact = `rgb(${data.contact})`;

// The colour of a clearance as sRGB components from 0 to 255; contact has a colour of its own.
function scaleColour(clearance) {
  const share = clearance === null ? 1 : Math.min(1, Math.max(0, clearance / data.scaleMost));
  const place = share * (data.scale.length - 1);
  const below = Math.min(Math.floor(place), data.scale.length - 2);
  return data.scale[below].map((value, i) => value + (place - below) * (data.scale[below + 1][i] - value));
}

const frameColour = (frame) => frame.trouble ? data.contact : scaleColour(frame.clearance);

// Fills an area of a canvas as the part is drawn in contact: in the colour of contact, with black hatching.
function fillContact(context, x, y, width, height) {
  context.save();
  context.beginPath();
  context.rect(x, y, width, height);
  context.clip();
  context.fillStyle = kContact;
  context.fill();
  context.strokeStyle = '#000';
  context.lineWidth = 1.5;
  context.beginPath();
  for (let at = x - height; at < x + width; at += 6) {
    context.moveTo(at, y + height);
    context.lineTo(at + height, y);
  }
  context.stroke();
  context.restore();
}

// ---- words ----

function clearanceWords(frame) {
  if (frame.isFree) return 'nothing to keep clear of';
  if (frame.trouble) return frame.trouble;
  return `${data.measure} ` + (frame.clearance === null ? 'out of range' : boundText(frame.clearance));
}

const turnedInAll = Math.round(frames[frames.length - 1].turned);
const placeWords = (frame) => `at ${digits(100 * frame.share)} % of the way` +
  (turnedInAll ? `, turned ${Math.round(frame.turned)}\u00b0 of ${turnedInAll}\u00b0` : '');

// The line below: how near, where a margin or a solid makes that differ from the clearance; or what the slack is about.
function distanceWords(frame) {
  if (frame.overlap) return (frame.trouble ? 'allowed is an overlap of ' : 'before the overlap may exceed ') + lengthText(frame.overlap);
  if (!frame.between || !frame.distance || !(frame.trouble || frame.margin)) return '';
  return `distance ${lengthText(frame.distance)}` + (frame.margin ? `, margin ${lengthText(frame.margin)}` : '');
}
