// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a result that taut writes and its schema refuses, and against a reader that takes
// another schema for the same: Ajv, which knows nothing of taut, must refuse and accept the same
// documents, and at the same places.
// TAUT_PROGRAM names the program. With TAUT_EVERY_CHANGE each key is changed in each way, else in one
// of them, another one from key to key.

import assert from "node:assert/strict";
import { rmSync } from "node:fs";
import { after, before, test } from "node:test";
import Ajv from "ajv";
import { schema } from "../schema.mjs";
import { folder, makeReports, refusalOf, write } from "./results.mjs";

const ajv = new Ajv({ allErrors: true, allowUnionTypes: true });
const validators = Object.fromEntries(["study", "identification", "comparison", "plan", "control"].map((name) =>
  [`taut-${name}`, ajv.compile({ ...schema, oneOf: undefined, $ref: `#/definitions/${name}` })]));

let reports;
before(() => (reports = makeReports()));
after(() => rmSync(folder, { recursive: true, force: true }));

/** Places that Ajv refuses. */
function refused(result) {
  const validate = validators[result.format];
  return validate(result) ? [] : validate.errors.map(({ instancePath, params }) => (params.missingProperty ? `${instancePath}/${params.missingProperty}` : instancePath));
}

/** Each member of each object; of what is alike, entries of a list and methods, the first alone. */
function* members(value, path = []) {
  if (Array.isArray(value)) {
    if (value.length > 0) yield* members(value[0], [...path, 0]);
  } else if (value !== null && typeof value === "object") {
    const all = Object.entries(value);
    for (const [key, member] of path.at(-1) === "methods" ? all.slice(0, 1) : all) {
      yield [...path, key];
      yield* members(member, [...path, key]);
    }
  }
}

function changed(result, path, change) {
  const copy = structuredClone(result);
  change(path.slice(0, -1).reduce((part, key) => part[key], copy), path.at(-1));
  return copy;
}

const set = (value) => (parent, key) => (parent[key] = value);
/** Where they alone are tried, no rule beyond the schema is broken: sizes, order, indices of the net. */
const exact = { "taken away": (parent, key) => delete parent[key], "null": set(null), "an object": set({}) };
const loose = { "a text": set("text"), "-1.5": set(-1.5) };

/** What taut says of a result; null where it makes a report. */
function taut(result) {
  write("changed", result);
  return refusalOf("report", "changed.json", "-o", "changed.html");
}

test("what taut writes keeps to the schema", () => {
  const validate = ajv.compile({ ...schema, $id: "all" });
  for (const { result } of Object.values(reports)) assert.ok(validate(result), JSON.stringify(validate.errors?.slice(0, 3)));
});

test("reader and schema refuse the same changes of a result, at the same places", () => {
  let tried = 0;
  let keys = 0;
  const everything = { ...reports.troubled.result, frame: reports.moved.result.frame };
  for (const [name, result] of Object.entries({ study: reports.study.result, identification: everything, comparison: reports.comparison.result, plan: reports.infeasible.result, control: reports.jobs.result })) {
    for (const path of members(result)) {
      // The format chooses the schema; the version and the net have words of their own.
      if (path[0] === "format" || path[0] === "version" || (path[0] === "cable_net" && path.length > 1)) continue;
      // An interval has both ends or none, which no schema expresses.
      const isEnd = name === "plan" && /^tension,edges,0,(lower|upper)$/.test(String(path));
      const isLeaf = typeof path.reduce((part, key) => part[key], result) !== "object";
      const ways = Object.entries(isLeaf ? { ...exact, ...loose } : exact);
      ++keys;
      for (const [words, change] of process.env.TAUT_EVERY_CHANGE ? ways : [ways[keys % ways.length]]) {
        if (isEnd && words === "null") continue;
        const document = changed(result, path, change);
        const places = refused(document);
        const said = taut(document);
        const what = `${name}: ${path.join("/")} ${words}`;
        ++tried;
        if (places.length > 0) {
          assert.ok(said !== null, `${what} is refused by the schema alone, at ${places}`);
          assert.ok(places.some((place) => said.includes(`changed.json:${place}: `)), `${what}: ${said}, expected one of ${places}`);
        } else if (words in exact) {
          assert.equal(said, null, `${what} is refused by the reader alone`);
        }
      }
    }
  }
  assert.ok(tried > (process.env.TAUT_EVERY_CHANGE ? 500 : 300), `${tried} changes`);
});
