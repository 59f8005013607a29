// node report.js FOLDER [PICTURES]: uses a report of `prelight compare` as a person would, with mouse and
// keys, and fails on anything that the console or the network hears of. Prints what failed, one line each.
// With a second folder it leaves screenshots there, for looking at.
"use strict";
const fs = require("fs");
const path = require("path");
const { pathToFileURL } = require("url");
const { Browser } = require("./browser.js");

const failures = [];
const check = (right, what) => { if (!right) failures.push(what); };

/** Sources of the two pictures, once both are there and not broken. */
const pictures = `Promise.all([...document.querySelectorAll("#stage img")].map((image) =>
  image.getAttribute("src") === null ? "none" : image.decode().then(() => image.naturalWidth > 0 ? image.getAttribute("src") : "broken", () => "broken")))`;
const splitOf = `parseFloat(document.getElementById("stage").style.getPropertyValue("--split"))`;
const box = (id) => `(() => { const at = document.getElementById("${id}"); at.scrollIntoView({ block: "center" });
  const b = at.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()`;

async function checkViews(browser, report) {
  const byKey = { 0: "final", 1: "depth", 2: "normal", 3: "diffuse-light", 4: "albedo" };
  const left = report.runs.find((run) => run.error === null).pictures, right = report.reference.pictures;
  for (const [key, view] of Object.entries(byKey)) {
    await browser.press(key);
    const shown = await browser.evaluate(pictures);
    check(shown[0] === (left[view] ?? "none"), `key ${key}: the left side shows ${shown[0]}, not ${left[view]}`);
    check(shown[1] === (right[view] ?? "none"), `key ${key}: the right side shows ${shown[1]}, not ${right[view]}`);
    check(await browser.evaluate(`document.querySelector("#views input:checked").value`) === view, `key ${key}: ${view} is not marked`);
  }
  await browser.press("0");
}

async function checkEveryPicture(browser, report) {
  const wanted = new Set([report.reference, ...report.runs].flatMap((run) => Object.values(run.pictures ?? {})));
  for (const file of wanted)
    check(fs.existsSync(path.join(folder, file)), `${file} is not there`);
  const sides = await browser.evaluate(`document.getElementById("left").options.length`);
  check(sides === 1 + report.runs.filter((run) => run.error === null).length, `${sides} variants to choose from`);
  for (let side = 0; side < sides; ++side) {
    await browser.evaluate(`(() => { const select = document.getElementById("right"); select.value = "${side}";
      select.dispatchEvent(new Event("change")); })()`);
    check(!(await browser.evaluate(pictures)).includes("broken"), `a picture of variant ${side} is broken`);
  }
  // What a variant lacks is told, not left blank.
  await browser.evaluate(`(() => { const view = document.getElementById("right-view"), select = document.getElementById("right");
    select.value = "0"; select.dispatchEvent(new Event("change")); view.value = "difference"; view.dispatchEvent(new Event("change")); })()`);
  check(await browser.evaluate(`!document.querySelector("#layer-right .missing").hidden`), "nothing says that the reference has no difference");
  check(await browser.evaluate(`document.querySelector("#views input:checked") === null`), "a buffer is marked although the sides differ");
  await browser.press("0");
}

async function checkDivider(browser) {
  const [left, top, width, height] = await browser.evaluate(box("stage"));
  check(width > 100 && height > 50, `the stage is ${width}×${height}`);
  await browser.drag([left + width / 2, top + height / 2], [left + width / 4, top + height / 2]);
  check(Math.abs(await browser.evaluate(splitOf) - 25) < 1, "dragging on the picture does not move the divider there");
  check(Math.abs(await browser.evaluate(`Number(document.getElementById("split").value)`) - 25) < 1, "the slider does not follow the drag");
  await browser.evaluate(`document.getElementById("split").focus()`);
  await browser.press("ArrowRight");
  check(Math.abs(await browser.evaluate(splitOf) - 25.5) < 1 && await browser.evaluate(splitOf) > 25.2, "an arrow key does not move the slider");
  await browser.press("End");
  check(await browser.evaluate(splitOf) === 100, "the key End does not move the slider to its end");
  const clip = await browser.evaluate(`getComputedStyle(document.getElementById("layer-right")).clipPath`);
  check(clip.includes("100%"), `the right picture is not covered: ${clip}`);
  await browser.evaluate(`document.getElementById("stage").focus()`);
  await browser.press("ArrowLeft");
  check(await browser.evaluate(splitOf) === 99, "an arrow key on the picture does not move the divider");
}

async function checkZoom(browser) {
  const scale = `(() => { const image = document.querySelector("#layer-left img");
    return image.getBoundingClientRect().width / ${"image.width"}; })()`;
  const place = `document.querySelector("#layer-left img").getBoundingClientRect().left`;
  const [left, top, width, height] = await browser.evaluate(box("stage"));
  const fit = await browser.evaluate(scale);
  await browser.click(left + width / 2, top + height / 2, 2);
  const once = await browser.evaluate(scale);
  check(once > fit, "a double click does not zoom in");
  for (let n = 0; n < 8; ++n) await browser.press("+");
  check(await browser.evaluate(scale) === 32, "the key + does not zoom to 32 pixels for one");
  check(await browser.evaluate(`getComputedStyle(document.querySelector("#layer-left img")).imageRendering`) === "pixelated", "zoomed pixels are blurred");
  check(await browser.evaluate(`document.getElementById("zoom-in").disabled`), "the button + is not disabled at the end");
  const before = await browser.evaluate(place);
  await browser.drag([left + width / 2 - 40, top + height / 2], [left + width / 2 - 90, top + height / 2]);
  check(Math.abs(before - 50 - await browser.evaluate(place)) < 1, "dragging does not move the zoomed picture");
  await browser.evaluate(`document.getElementById("stage").focus()`);
  await browser.press("ArrowRight");
  check(Math.abs(before - 90 - await browser.evaluate(place)) < 1, "arrow keys do not move the zoomed picture");
  if (shots) await browser.screenshot(path.join(shots, "zoomed.png"), false);
  await browser.press("f");
  check(Math.abs(await browser.evaluate(scale) - fit) < 1e-6, "the key F does not fit the picture again");
}

/** Everything that Tab reaches has a visible focus and a name. */
async function checkFocus(browser) {
  await browser.evaluate(`document.querySelector(".skip").focus()`);
  const seen = new Set();
  for (let n = 0; n < 60; ++n) {
    await browser.press("Tab");
    const at = JSON.parse(await browser.evaluate(`(() => { const at = document.activeElement;
      if (at === document.body) return "null";
      const shown = at.matches("#views input") ? at.nextElementSibling : at, style = getComputedStyle(shown);
      const name = at.getAttribute("aria-label") || at.labels?.[0]?.textContent || at.textContent;
      return JSON.stringify({ what: at.id || at.tagName + " " + name.trim().slice(0, 30), outline: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2, named: name.trim() !== "" }); })()`));
    if (at === null) break;
    check(at.outline, `the focus on ${at.what} cannot be seen`);
    check(at.named, `${at.what} has no name`);
    seen.add(at.what);
  }
  for (const id of ["left", "right", "stage", "split", "zoom-in", "shares"]) check(seen.has(id), `Tab does not reach ${id}`);
}

async function checkFigures(browser, report) {
  const good = report.runs.filter((run) => run.error === null);
  const count = (selector) => browser.evaluate(`document.querySelectorAll(${JSON.stringify(selector)}).length`);
  check(await count("#summary tbody tr") === report.runs.length, "the table lacks a variant");
  check(await count("#summary .failed") === report.runs.length - good.length, "failures are not told");
  check(await count("#bars .bar") === good.length, "a variant has no bar");
  check(await count("#bars .track div") === good.reduce((sum, run) => sum + run.passes.length, 0), "a pass is not in its bar");
  check(await count("#passes details") === good.length, "a variant has no table of passes");
  const points = report.light_counts.reduce((sum, line) => sum + line.points.length, 0);
  check(await count("#chart-time circle") === points, "the chart of times lacks a point");
  check(await count("#chart-share circle") === report.light_counts.flatMap((line) => line.points).filter((point) => point.light_pass_share !== null).length,
    "the chart of shares lacks a point");
  check(await browser.evaluate(`document.getElementById("metric").value`) === report.steady_time, "the chart does not begin with the steadier time");
  const cell = () => browser.evaluate(`document.querySelector("#costs tbody td").textContent`);
  const digits = (text) => Number(text.replaceAll(",", ""));
  for (const metric of ["gpu_ms", "cpu_ms"]) {
    await browser.evaluate(`(() => { const at = document.getElementById("metric"); at.value = "${metric}"; at.dispatchEvent(new Event("change")); })()`);
    const right = report.light_counts[0].points[0][metric].median;
    check(Math.abs(digits(await cell()) - right) <= 0.02 * right + 0.01, `${metric}: the table says ${await cell()}, not ${right}`);
  }
  await browser.evaluate(`document.querySelector("#lines input").click()`);
  await browser.settle();
  check(await count("#chart-time circle") === points - report.light_counts[0].points.length, "a line cannot be taken out of the chart");
  await browser.evaluate(`document.querySelector("#lines input").click(); document.getElementById("shares").click()`);
  const full = await browser.evaluate(`[...document.querySelectorAll("#bars .track")].every((track) =>
    Math.abs([...track.children].reduce((sum, part) => sum + part.getBoundingClientRect().width, 0) - track.clientWidth) < 1)`);
  check(full, "bars of shares are not full");
  await browser.evaluate(`document.getElementById("shares").click()`);
  const text = await browser.evaluate("document.body.innerText");
  for (const wrong of ["NaN", "undefined", "Infinity", "[object"]) check(!text.includes(wrong), `the page says ${wrong}`);
}

/** Each architecture with its picture, a diagram whose words stay in their boxes, and its equation. */
async function checkArchitectures(browser, report) {
  const names = [...new Set(report.runs.filter((run) => run.error === null).map((run) => run.renderer))];
  const shown = await browser.evaluate(`[...document.querySelectorAll(".architecture")].map((at) => [at.getAttribute("aria-label"),
    at.querySelectorAll("img").length, at.querySelectorAll("math").length > 0 && at.querySelector("math").getBoundingClientRect().height > 10,
    at.querySelector("svg").getAttribute("aria-label").length > 20,
    [...at.querySelectorAll("svg text")].every((text) => { const b = text.getBBox(); const box = [...at.querySelectorAll("svg rect")].map((rect) => rect.getBBox())
      .find((r) => r.x <= b.x && b.y >= r.y - 1 && b.y + b.height <= r.y + r.height + 1 && b.x < r.x + r.width); return text.classList.contains("loop") || (box && b.x + b.width <= box.x + box.width); })])`);
  check(shown.length === names.length, `${shown.length} of ${names.length} architectures are explained`);
  for (const [name, images, formula, label, inside] of shown) {
    check(images === 1, `${name} stands without its picture`);
    check(formula, `${name} has no equation`);
    check(label, `the diagram of ${name} says nothing to who can't see it`);
    check(inside, `words of the diagram of ${name} leave their box`);
  }
}

/** Passes can be told apart, and short bars be read beside long ones. */
async function checkBars(browser, report) {
  const fills = await browser.evaluate(`[...document.querySelectorAll("#legend .swatch")].map((at) => getComputedStyle(at).background)`);
  check(new Set(fills).size === fills.length, "two passes look the same");
  const many = await browser.evaluate(`[...Array(32).keys()].map(fill)`);
  check(new Set(many).size === 32, "of 32 passes two would look the same");
  const totals = report.runs.filter((run) => run.error === null).map((run) => run.passes.reduce((sum, pass) => sum + pass.gpu_ms.median, 0));
  const drawn = `(() => { const place = document.createElement("div"); place.style.width = "800px"; document.body.append(place);
    const bar = (ms) => ({ name: "x", total: ms, parts: [{ name: "p", ms }] });
    const cut = document.getElementById("cut"), was = cut.checked; cut.checked = CUT; drawBars(place, [bar(10), bar(12), bar(1000)], ["p"]);
    const all = [...place.querySelectorAll(".track")].map((at) => [at.firstChild.getBoundingClientRect().width / at.clientWidth, at.classList.contains("over")]);
    place.remove(); cut.checked = was; return all; })()`;
  const far = await browser.evaluate(drawn.replace("CUT", "false")), near = await browser.evaluate(drawn.replace("CUT", "true"));
  check(far[0][0] < 0.02 && !far[2][1], "bars do not have one scale");
  check(Math.abs(near[0][0] - 10 / 12) < 0.01 && near[2][1], "a long bar is not cut off");
  check(totals.length > 0, "no bar");
  const texts = await browser.evaluate(`[slopeText(10, 1), slopeText(10, 6), slopeText(-73.5, 1), slopeText(null, null)]`);
  check(JSON.stringify(texts) === JSON.stringify(["10.0 ± 1.00", "not measurable", "not measurable", "–"]), `slopes read ${texts}`);
}

async function checkSizes(browser) {
  const background = [];
  for (const theme of ["light", "dark"])
    for (const width of [1280, 400]) {
      await browser.look(width, 900, theme);
      const over = await browser.evaluate(`(() => { const wide = document.documentElement.scrollWidth; if (wide <= ${width}) return "";
        const worst = [...document.querySelectorAll("body *")].find((at) => at.getBoundingClientRect().right > ${width} + 0.5 && !at.closest(".scroll, .skip"));
        return wide + " pixels wide, by " + (worst ? worst.tagName + "#" + worst.id + "." + worst.className : "?"); })()`);
      check(over === "", `at ${width} pixels, ${theme}, the page is ${over}`);
      if (shots) await browser.screenshot(path.join(shots, `${width}-${theme}.png`));
      if (width === 1280) background.push(await browser.evaluate(`getComputedStyle(document.documentElement).backgroundColor`));
    }
  check(background[0] !== background[1], "dark and light look the same");
  await browser.look(1280, 900, "light");
}

async function main(browser) {
  const report = JSON.parse(fs.readFileSync(path.join(folder, "report.json"), "utf8"));
  await browser.open();
  await browser.look(1280, 900, "light");
  await browser.goTo(pathToFileURL(path.join(folder, "index.html")).href);
  await browser.settle();
  check(await browser.evaluate(`document.getElementById("headline").textContent.length > 0`), "there is no headline");
  check(await browser.evaluate(`JSON.stringify(JSON.parse(document.getElementById("data").textContent))`) === JSON.stringify(report),
    "the page's data are not those of report.json");
  await checkViews(browser, report);
  await checkEveryPicture(browser, report);
  await checkDivider(browser);
  await checkZoom(browser);
  await checkFigures(browser, report);
  await checkArchitectures(browser, report);
  await checkBars(browser, report);
  await checkFocus(browser);
  await checkSizes(browser);
  for (const url of browser.requests) check(/^(file|data):/.test(url), `it asks the network for ${url}`);
  check(browser.requests.length > 2, "no request was seen at all: the test is blind");
  failures.push(...browser.complaints);
}

const folder = path.resolve(process.argv[2]), shots = process.argv[3];
const browser = new Browser(process.env.CHROMIUM ?? "chromium");
main(browser).catch((error) => failures.push(error.stack)).then(() => browser.close()).then(() => {
  for (const failure of failures) console.log(failure);
  process.exit(failures.length ? 1 : 0);
});
