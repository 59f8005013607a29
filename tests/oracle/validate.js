// node validate.js FILE…: the Khronos validator. Prints what it finds of severity error or warning and
// one line of counts for each file; exit status 1 when there is an error.
'use strict';
const fs = require('fs');
const validator = require('gltf-validator');

async function validate(file) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
        uri: file,
        maxIssues: 100,
    });
    const { messages, numErrors, numWarnings, numInfos } = report.issues;
    for (const { severity, code, message, pointer } of messages)
        if (severity < 2)
            console.log(`  ${severity === 0 ? 'error' : 'warning'} ${code}: ${message} ${pointer}`);
    console.log(`  validator: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} notes`);
    return numErrors === 0;
}

(async () => {
    let good = process.argv.length > 2;
    for (const file of process.argv.slice(2))
        good = (await validate(file)) && good;
    process.exitCode = good ? 0 : 1;
})();
