// node tangents.js IN OUT: runs the npm package mikktspace (the reference implementation compiled to
// WebAssembly). IN: little-endian floats, per corner 3 position, 3 normal, 2 texture coordinate.
// OUT: per corner 4 floats, the tangent in MikkTSpace's own convention.
'use strict';
const fs = require('fs');
const { generateTangents } = require('mikktspace');

const [input, output] = process.argv.slice(2);
const bytes = fs.readFileSync(input);
const corners = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
const count = corners.length / 8;
const pick = (first, width) => {
    const values = new Float32Array(count * width);
    for (let i = 0; i < count; ++i)
        for (let k = 0; k < width; ++k)
            values[i * width + k] = corners[i * 8 + first + k];
    return values;
};
const tangents = generateTangents(pick(0, 3), pick(3, 3), pick(6, 2));
fs.writeFileSync(output, Buffer.from(tangents.buffer, tangents.byteOffset, tangents.byteLength));
