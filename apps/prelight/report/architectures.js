// How each architecture works: its passes as a diagram, and its equation, beside its picture.

/** MathML, from text of this file only. */
function formula(markup) {
  const box = element("div", { class: "formula" });
  box.innerHTML = `<math display="block">${markup}</math>`;
  return box;
}

const mi = (name) => `<mi>${name}</mi>`, mo = (sign) => `<mo stretchy="false">${sign}</mo>`;
const sub = (base, index) => `<msub>${mi(base)}${mi(index)}</msub>`;
const lightSum = (below = "") => `<munder><mo>∑</mo><mrow>${mi("i")}${below}</mrow></munder>`;
const within = (what) => `${mo("∈")}<mtext>${what}</mtext>`;
const lit = `${mo("(")}${mi("N")}${mo("·")}${sub("L", "i")}${mo(")")}${sub("I", "i")}`;
const brdf = `${mi("f")}${mo("(")}${sub("L", "i")}${mo(",")}${mi("V")}${mo(")")}`;
const equals = (left) => `${mi(left)}${mo("=")}`;
const rest = `${mo("+")}${mi("A")}${mo("+")}${mi("E")}`;

/** `steps`: [pass, what it does, what it writes, for what it is repeated]. */
const architectures = {
  "light-prepass": {
    steps: [["Geometry", "what is seen", "depth, normal, roughness"], ["Lights", "summed at each pixel", "diffuse sum D, specular sum S", "each light"],
      ["Geometry again", "each object's own material", "picture"]],
    equations: [`${equals("L")}${sub("c", "d")}${mi("D")}${mo("+")}${sub("c", "s")}${mi("S")}${rest}`,
      `${equals("D")}${lightSum()}${lit}<mspace width="1.5em"></mspace>${equals("S")}${lightSum()}${lit}${sub("s", "i")}`],
    text: "The material's colours c come out of the sums, so that lights need to know normals and roughness alone, and each object may have a shader of its own.",
    cost: "Geometry twice; each light costs the pixels that it reaches.",
  },
  inferred: {
    steps: [["Geometry, smaller", "what is seen, and up to three layers of glass in every fourth texel", "depth, normal, roughness, surface"],
      ["Lights, smaller", "summed at each texel", "diffuse sum D, specular sum S", "each light"],
      ["Geometry again", "each object's own material, with the light of its own texels", "picture"]],
    equations: [`${equals("L")}${sub("c", "d")}<mover>${mi("D")}${mo("¯")}</mover>${mo("+")}${sub("c", "s")}<mover>${mi("S")}${mo("¯")}</mover>${rest}`,
      `<mover>${mi("D")}${mo("¯")}</mover>${mo("=")}<munder>${mo("∑")}<mtext>texels of the surface</mtext></munder>${sub("w", "t")}${sub("D", "t")}`],
    text: "The light pre-pass with its light at a lower resolution. A pixel takes the mean of those of the four texels around it that show its own surface.",
    cost: "Geometry twice, once into a smaller buffer; each light costs the texels that it reaches, and blended surfaces cost no light of their own.",
  },
  deferred: {
    steps: [["Geometry", "what is seen, with its material", "G-buffer: depth, normal, colours"], ["Lights", "whole equation at each pixel", "picture", "each light"]],
    equations: [`${equals("L")}${lightSum()}${brdf}${lit}${rest}`],
    text: "The reflectance f is evaluated for each light with what the G-buffer holds of the material: one equation for all objects.",
    cost: "Geometry once, into the widest buffer; each light costs the pixels that it reaches, and reads the material there.",
  },
  "z-prepass": {
    steps: [["Geometry", "depth alone", "depth"], ["Geometry again", "material and lights in one shader", "picture", "eight lights, or all from a grid"]],
    equations: [`${equals("L")}${lightSum(within("object"))}${brdf}${lit}${rest}`],
    text: "Depth first, so that only what is seen is shaded; then forward, with depth test EQUAL.",
    cost: "Geometry twice or more; an object's lights cost all of its pixels.",
  },
  multipass: {
    steps: [["Geometry", "ambient and emissive light", "picture, depth"], ["Geometry again", "its next lights, added", "picture", "the lights of each object"]],
    equations: [`${equals("L")}${mi("A")}${mo("+")}${mi("E")}${mo("+")}<munder><mo>∑</mo><mtext>passes</mtext></munder>${lightSum(within("pass"))}${brdf}${lit}`],
    text: "Every object is drawn again for its lights, and blending adds the results.",
    cost: "Geometry × lights: what the others were invented against.",
  },
};

/** Passes down the left, what they write down the right. */
function diagram(steps) {
  const rows = steps.map(([pass, does, writes, loop], index) => ({ pass, does, writes, loop, y: 8 + index * 92 }));
  const height = rows.length * 92 - 14;
  const label = steps.map(([pass, does, writes, loop]) => `${pass}: ${does}${loop ? `, for ${loop}` : ""}, gives ${writes}`).join("; then ");
  const svg = element("svg", { class: "diagram", viewBox: `0 0 360 ${height}`, role: "img", "aria-label": label });
  const lines = (text, width) => text.split(" ").reduce((all, word) => {
    const last = all[all.length - 1];
    if (last !== undefined && `${last} ${word}`.length <= width) all[all.length - 1] = `${last} ${word}`;
    else all.push(word);
    return all;
  }, []);
  rows.forEach(({ pass, does, writes, loop, y }, index) => {
    svg.append(element("rect", { class: "pass", x: 1, y, width: 168, height: 62, rx: 7 }),
      element("text", { class: "title", x: 12, y: y + 18 }, pass),
      ...lines(does, 20).slice(0, 2).map((line, row) => element("text", { x: 12, y: y + 35 + row * 15 }, line)));
    if (loop) svg.append(element("text", { class: "loop", x: 12, y: y + 76 }, `↻ for ${loop}`));
    const parts = lines(writes, 17);
    svg.append(element("path", { class: "flow", d: `M169 ${y + 31}H202` }), element("path", { class: "head", d: `M202 ${y + 26}l8 5l-8 5z` }),
      element("rect", { class: "buffer", x: 211, y: y + 4, width: 148, height: 54 }),
      ...parts.map((line, row) => element("text", { x: 221, y: y + 35 - (parts.length - 1) * 7.5 + row * 15 }, line)));
    if (index + 1 < rows.length)
      svg.append(element("path", { class: "flow", d: `M285 ${y + 58}V${y + 80}H190V${y + 106}H178` }), element("path", { class: "head", d: `M178 ${y + 101}l-8 5l8 5z` }));
  });
  return svg;
}

function showArchitectures(runs) {
  const names = [...new Set(runs.map((run) => titleOf(run.variant).name))].filter((name) => architectures[name]);
  const place = document.getElementById("architectures");
  place.hidden = names.length === 0;
  for (const name of names) {
    const { steps, equations, text, cost } = architectures[name];
    const run = runs.find((one) => titleOf(one.variant).name === name);
    place.append(element("article", { class: "architecture", "aria-label": name }, element("h3", {}, name),
      element("img", { src: run.pictures.final, alt: `The picture of ${plainName(run.variant)}` }),
      diagram(steps),
      element("div", {}, ...equations.map(formula), element("p", {}, text), element("p", { class: "caption" }, cost))));
  }
}
