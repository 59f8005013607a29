// node bench.js PAGE [PICTURES]: uses a page of `prelight bench report` as a person would, and fails on anything
// that the console or the network hears of. Prints what failed, one line each. With a folder it leaves
// screenshots there, for looking at.
"use strict";
const fs = require("fs");
const path = require("path");
const { pathToFileURL } = require("url");
const { Browser } = require("./browser.js");

const failures = [];
const check = (right, what) => { if (!right) failures.push(what); };

async function checkFigures(browser, files) {
  const count = (selector) => browser.evaluate(`document.querySelectorAll(${JSON.stringify(selector)}).length`);
  const runs = files.flatMap(({ bench }) => bench.runs), limits = files.flatMap(({ bench }) => bench.limit?.figures ?? []);
  check(await count("#summary tbody tr") === runs.length, "the table lacks a run");
  check(await count("#passes details") === runs.length, "a run has no table of passes");
  check(await count("#limits tbody tr") === limits.length, "a figure of the limit is missing");
  check(await browser.evaluate(`document.getElementById("limit").hidden`) === (limits.length === 0), "the limit is shown without figures, or hidden");
  if (new Set(runs.map((run) => run.lights)).size > 1) await checkChart(browser, runs, limits, count);
  else {
    check(await count("svg circle") === 0, "a chart is drawn of one number of lights");
    check(await browser.evaluate(`document.querySelector(".charts").getBoundingClientRect().height`) === 0, "the place of a chart is left empty");
    check((await browser.evaluate(`document.getElementById("lights-caption").textContent`)).includes("no line to draw"), "nothing says why there is no chart");
  }
  const fills = await browser.evaluate(`[...document.querySelectorAll("#legend .swatch")].map((at) => getComputedStyle(at).background)`);
  check(new Set(fills).size === fills.length, "two passes look the same");
  const counts = await browser.evaluate(`[...document.getElementById("count").options].map((option) => option.value)`);
  for (const lights of counts) {
    await browser.evaluate(`(() => { const at = document.getElementById("count"); at.value = "${lights}"; at.dispatchEvent(new Event("change")); })()`);
    check(await count("#bars .bar") === runs.filter((run) => String(run.lights) === lights).length, `${lights} lights: a run has no bar`);
  }
  await browser.evaluate(`document.getElementById("shares").click()`);
  const full = await browser.evaluate(`[...document.querySelectorAll("#bars .track")].every((track) =>
    Math.abs([...track.children].reduce((sum, part) => sum + part.getBoundingClientRect().width, 0) - track.clientWidth) < 1)`);
  check(full, "bars of shares are not full");
  await browser.evaluate(`document.getElementById("shares").click()`);
  const text = await browser.evaluate("document.body.innerText");
  for (const wrong of ["NaN", "undefined", "Infinity", "[object", "null"]) check(!text.includes(wrong), `the page says ${wrong}`);
  const cell = await browser.evaluate(`document.querySelector("#summary tbody tr td[data-label='CPU, ms'] span").firstChild.textContent`);
  const shown = Number(cell.replaceAll(",", "").split(" ")[0]), right = runs[0].cpu_ms.median;
  check(Math.abs(shown - right) <= 0.02 * right + 0.01, `the table says ${cell}, not ${right}`);
}

async function checkChart(browser, runs, limits, count) {
  const points = await count("#chart-time circle");
  check(points === (limits.length || runs.length), `the chart has ${points} points`);
  const metrics = await browser.evaluate(`[...document.getElementById("metric").options].map((option) => option.textContent)`);
  check((metrics[0] === "in F") === limits.length > 0, `times are offered as ${metrics}`);
  for (let index = 0; index < metrics.length; ++index) {
    await browser.evaluate(`(() => { const at = document.getElementById("metric"); at.value = "${index}"; at.dispatchEvent(new Event("change")); })()`);
    const expected = metrics[index] === "in F" ? limits.length : runs.length;
    check(await count("#chart-time circle") === expected, `${metrics[index]}: the chart has not ${expected} points`);
  }
  await browser.evaluate(`document.querySelector("#lines input").click()`);
  await browser.settle();
  check(await count("#chart-time circle") < runs.length, "a line cannot be taken out of the chart");
  await browser.evaluate(`document.querySelector("#lines input").click()`);
}

async function checkSizes(browser) {
  const background = [];
  for (const theme of ["light", "dark"])
    for (const width of [1280, 400]) {
      await browser.look(width, 900, theme);
      const wide = await browser.evaluate("document.documentElement.scrollWidth");
      check(wide <= width, `at ${width} pixels, ${theme}, the page is ${wide} pixels wide`);
      if (shots) await browser.screenshot(path.join(shots, `bench-${width}-${theme}.png`));
      if (width === 1280) background.push(await browser.evaluate(`getComputedStyle(document.documentElement).backgroundColor`));
    }
  check(background[0] !== background[1], "dark and light look the same");
}

async function main(browser) {
  await browser.open();
  await browser.look(1280, 900, "light");
  await browser.goTo(pathToFileURL(page).href);
  await browser.settle();
  check(await browser.evaluate(`document.getElementById("headline").textContent.length > 0`), "there is no headline");
  const files = JSON.parse(await browser.evaluate(`document.getElementById("data").textContent`));
  await checkFigures(browser, files);
  await checkSizes(browser);
  for (const url of browser.requests) check(/^(file|data):/.test(url), `it asks the network for ${url}`);
  check(browser.requests.length > 0, "no request was seen at all: the test is blind");
  failures.push(...browser.complaints);
}

const page = path.resolve(process.argv[2]), shots = process.argv[3];
if (shots) fs.mkdirSync(shots, { recursive: true });
const browser = new Browser(process.env.CHROMIUM ?? "chromium");
main(browser).catch((error) => failures.push(error.stack)).then(() => browser.close()).then(() => {
  for (const failure of failures) console.log(failure);
  process.exit(failures.length ? 1 : 0);
});
