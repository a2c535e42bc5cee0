// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The licences of the npm packages whose code is in a bundle, which ask to go with every copy of it.

import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";

/** The folders of the packages that a bundle of esbuild has code of, by its metafile. */
export function packagesIn(metafile) {
  const folders = Object.values(metafile.outputs).flatMap(({ inputs }) => Object.entries(inputs))
    .filter(([, { bytesInOutput }]) => bytesInOutput > 0)
    .map(([file]) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(file)?.[0]);
  return [...new Set(folders.filter(Boolean))].sort();
}

/** Name, version and licence of a package. Fails where no licence lies in its folder. */
async function noticeOf(folder) {
  const { name, version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  const files = (await readdir(folder)).filter((file) => /^(licen[cs]e|copying|notice)/i.test(file)).sort();
  if (!files.some((file) => !/^notice/i.test(file))) {
    throw new Error(`${folder}: code of ${name} ${version} is in the bundle, expected a file LICENSE or COPYING of the package`);
  }
  const texts = await Promise.all(files.map((file) => readFile(join(folder, file), "utf8")));
  return { name: `${name} ${version}`, text: texts.map((text) => text.trim()).join("\n\n") };
}

/** The licences of packages by their folders; packages with the same text share it. */
export async function noticesOf(folders) {
  const names = new Map();
  for (const { name, text } of await Promise.all(folders.map(noticeOf))) names.set(text, [...(names.get(text) ?? []), name]);
  return [...names].map(([text, packages]) => ({ packages, text }));
}

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");

/** Notices as HTML. */
export function markup(notices) {
  return notices.map(({ packages, text }) => `<h3>${escaped(packages.join(", "))}</h3>\n<pre>${escaped(text)}</pre>`).join("\n");
}
