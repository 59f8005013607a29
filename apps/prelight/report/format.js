// Numbers, names and elements.
"use strict";

/** An element with attributes and children; text is never taken for markup. */
function element(tag, attributes = {}, ...children) {
  const svg = ["svg", "g", "line", "path", "circle", "text", "title", "rect"].includes(tag);
  const made = svg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

const whole = new Intl.NumberFormat("en-US");

/** Three significant digits, without an exponent. */
function figure(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size >= 100) return whole.format(Math.round(value));
  return value.toFixed(size >= 10 ? 1 : size >= 1 || size === 0 ? 2 : 3);
}

const milliseconds = (value) => `${figure(value)} ms`;
const megabytes = (bytes) => `${figure(bytes / 1e6)} MB`;
const percent = (share) => (share === null ? "–" : `${(share * 100).toFixed(share < 0.0995 ? 1 : 0)} %`);
const decibels = (value) => (value === null ? "∞" : value.toFixed(1));
const times = (ratio) => `${figure(ratio)}×`;

/** "light-prepass@light-culling=tiles" as its architecture and what is special about it. */
function titleOf(variant) {
  const [name, ...rest] = variant.split("@");
  return { name, detail: rest.join(", ").replaceAll("=", ": ") };
}

/** The variant's name for a cell; one with settings is set in below its architecture. */
function nameOf(variant) {
  const { name, detail } = titleOf(variant);
  return detail ? element("span", { class: "child" }, name, element("span", { class: "detail" }, detail)) : name;
}

function plainName(variant) {
  const { name, detail } = titleOf(variant);
  return detail ? `${name} (${detail})` : name;
}

/** Colours repeat after eight; what repeats gets a dash pattern where there are lines, and stripes where there are areas. */
const colour = (index) => `var(--c${index % 8})`;

/** Style of an area: eight colours, then the same striped upwards, striped downwards, and chequered. */
function fill(index) {
  const own = colour(index), stripes = (angle) => `repeating-linear-gradient(${angle}deg,${own} 0 4px,var(--page) 4px 6px)`;
  const patterns = [own, stripes(45), stripes(-45), `repeating-conic-gradient(${own} 0 25%,var(--page) 0 50%) 0 0/6px 6px`];
  return `background:${patterns[Math.floor(index / 8) % patterns.length]}`;
}

/** A slope with what it may be off by; one that noise could have made is none. */
const isMeasured = (slope, error) => slope !== null && slope !== undefined && slope > 2 * (error ?? 0);
const slopeText = (slope, error) => (slope === null || slope === undefined ? "–" : isMeasured(slope, error) ? `${figure(slope)} ± ${figure(error)}` : "not measurable");
