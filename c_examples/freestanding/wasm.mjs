// Runs a module of wasm.c: node wasm.mjs module.wasm
import { readFileSync } from "node:fs";

let memory;
const write = (text, length) => process.stdout.write(new Uint8Array(memory.buffer, text, length));
const module = new WebAssembly.Module(readFileSync(process.argv[2]));
const { exports } = new WebAssembly.Instance(module, { host: { write } });
memory = exports.memory;
process.exitCode = exports.run();
