// The Khronos validator on files: `node validate.mjs FILE...`. Exit 1 when any of them has an error or a warning.
import fs from 'node:fs';
import path from 'node:path';
import { createRequire } from 'node:module';

const validator = createRequire(import.meta.url)('gltf-validator');
let bad = 0;
for (const file of process.argv.slice(2)) {
  const beside = name => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(name))).then(bytes => new Uint8Array(bytes));
  const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)),
    { uri: path.basename(file), maxIssues: 100, externalResourceFunction: beside });
  console.log(`${file}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ${issues.numInfos} infos`);
  for (const m of issues.messages)
    if (m.severity < 2) console.log(`  ${m.code} ${m.pointer ?? ''} ${m.message}`);
  if (issues.numErrors + issues.numWarnings) bad = 1;
}
process.exit(bad);
