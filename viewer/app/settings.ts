// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// What can be set, each an option of the program's.

import { h } from "../src/dom";

export interface Setting {
  option: string;
  /** Where its value is kept, if not by its option: two commands may have one of the same name. */
  key?: string;
  label: string;
  /** What is taken where nothing is given. */
  preset: string;
  hint?: string;
  /** Each number in it takes a unit. */
  unit?: string;
  choices?: string[];
  /** It holds options as on the command line. */
  isWords?: boolean;
  /** Each word in it is a value of the option's own. */
  isRepeated?: boolean;
}

const further = (command: string): Setting => ({ option: `further ${command} options`, label: "Further options", preset: "none", hint: `as taut ${command} takes them`, isWords: true });

export const identifySettings: Setting[] = [
  { option: "--noise", unit: "mm", label: "Standard deviation of the survey", preset: "the file's, or its last digit", hint: "of each coordinate, where the file has none: 0.5mm, or estimate" },
  { option: "--prior", label: "Fabrication tolerance (prior)", preset: "a broad one around uniform:5mm", hint: "uniform:5mm, normal:2mm, bimodal:5mm" },
  { option: "--uncertain", isRepeated: true, label: "Uncertain parameters", preset: "those of an ordinary site", hint: "stiffness:5% supports:2mm, or none" },
  { option: "--offset", unit: "mm", label: "Offset of the targets", preset: "0mm", hint: "from the cable's axis, and its standard deviation: 3mm:0.2mm" },
  { option: "--unit", label: "Unit of the coordinates", preset: "the file's, or by its extent", choices: ["m", "mm", "cm", "ft", "us-ft", "in"] },
  { option: "--frame", label: "Coordinate system", preset: "auto", choices: ["net", "supports"] },
  { option: "--draws", label: "Posterior samples", preset: "by the net's size", hint: "200; a plan needs them" },
  further("identify"),
];

export const planSettings: Setting[] = [
  { option: "--tension", isRepeated: true, unit: "kN", label: "Limits of tension", preset: "no edge slack", hint: "1.5kN..10kN, several apart by blanks" },
  { option: "--reaction", isRepeated: true, unit: "kN", label: "Largest force at a support", preset: "any", hint: "20kN" },
  { option: "--stroke", unit: "mm", label: "Largest change of length", preset: "15mm", hint: "of a turnbuckle from where it is now" },
  { option: "--turn", unit: "mm", label: "Change of length by one turn", preset: "lengths alone", hint: "pitch: 5mm" },
  { option: "--step", label: "Smallest part of a turn", preset: "any", hint: "1/4; needs the pitch" },
  { option: "--thread", label: "Thread", preset: "that of the net", choices: ["right", "left"] },
  { option: "--tolerance", unit: "mm", label: "Good enough", preset: "as near as can be", hint: "RMS along the normal: 2mm; then the fewest turns" },
  { option: "--crews", label: "Crews", preset: "1" },
  { option: "--stages", label: "Stages", preset: "all at once", hint: "groups of the net in turn: ridge:50%, valley, ridge" },
  { option: "--target-tension", isRepeated: true, unit: "kN", label: "Target tension", preset: "none", hint: "12kN:5%, that of a group 12kN:5%@ridge" },
  { option: "--suggest-adjustable", label: "Further edges to suggest", preset: "none", hint: "3: those that would help most if they could be turned" },
  { option: "--suggest-targets", unit: "mm", label: "Further targets to suggest", preset: "none", hint: "surveyed to 0.5mm before turning" },
  further("plan"),
];

/** Of further measurements. */
export const suggestSettings: Setting[] = [
  { option: "--suggest", label: "They are to determine", preset: "mean-tension", choices: ["worst-tension", "form"] },
  { option: "--cost", isRepeated: true, label: "Cost of one measurement", preset: "1 each", hint: "load-cell:5 frequency:1 sag:2 target:1 load:8" },
];

/** Of force measurements. */
export const forceSettings: Setting[] = [
  { option: "--force-unit", label: "Unit of the measured forces", preset: "N", choices: ["N", "kN"] },
];

export const importSettings: Setting[] = [
  { option: "--axial-stiffness", unit: "kN", label: "Axial stiffness EA", preset: "the file's", hint: "200kN" },
  { option: "--young", unit: "GPa", label: "Young's modulus", preset: "the file's", hint: "205GPa" },
  { option: "--diameter", label: "Diameter", preset: "the file's", hint: "mm, or the attribute that gives it" },
  { option: "--force-unit", key: "import --force-unit", label: "Unit of forces", preset: "the file's", choices: ["N", "kN"] },
  { option: "--supports", label: "Further supports", preset: "none", choices: ["boundary"] },
  { option: "--loads", label: "Loads", preset: "the file's", choices: ["balance", "none"], hint: "balance: those that hold the given form" },
  { option: "--slides", label: "Cables that slide through their nodes", preset: "none", choices: ["names", "straight"], hint: "edges of one name but for a number, or that go straight on" },
];

const allSettings = [...identifySettings, ...planSettings, ...suggestSettings, ...forceSettings, ...importSettings];

/** A message of the program with the labels of the page's fields in place of its options. */
export const inFields = (message: string): string =>
  message.replace(/--[a-z][a-z-]*/g, (option) => {
    const setting = allSettings.find((one) => one.option === option);
    return setting ? `“${setting.label}”` : option;
  });

/** Fields for settings, whose values they keep in `values`. @param changed called after each change */
export function fields(settings: Setting[], values: Record<string, string>, changed: () => void): HTMLElement {
  return h("div", { class: "fields" }, ...settings.map((setting) => {
    const { option, label, preset, hint, choices } = setting;
    const key = setting.key ?? option;
    const keep = ({ target }: Event): void => { values[key] = (target as HTMLInputElement | HTMLSelectElement).value.trim(); changed(); };
    const control = choices
      ? h("select", { name: option, onchange: keep }, ...["", ...choices].map((choice) => h("option", { value: choice, selected: choice === (values[key] ?? "") }, choice || preset)))
      : h("input", { name: option, type: "text", placeholder: preset, value: values[key] ?? "", oninput: keep, autocomplete: "off", spellcheck: "false" });
    return h("label", { class: "field" }, h("span", {}, label), control, hint ? h("small", {}, hint) : null);
  }));
}

/** Words apart by blanks, or in quotes. Throws where a quote does not end. */
function shellWords(line: string, label: string): string[] {
  const word = /\s*(?:"([^"]*)"|'([^']*)'|([^\s"']+))(?=\s|$)/y;
  const words: string[] = [];
  const end = line.trimEnd();
  for (let at = 0; at < end.length; at = word.lastIndex) {
    word.lastIndex = at;
    const found = word.exec(end);
    if (!found) throw new Error(`${label}: cannot be split into words from ${end.slice(at).trim()} on. Is a quote open?`);
    words.push(found[1] ?? found[2] ?? found[3]!);
  }
  return words;
}

/** Those of some words that are options which decide how a survey is read, with what is given to them. */
export function readingWords(words: string[]): string[] {
  const taken = ["--format", "--columns", "--separator", "--decimal", "--encoding", "--match", "--offsets", "--angle", "--range"];
  return words.filter((word, i) => taken.includes(word.replace(/=.*/, "")) || (!word.startsWith("--") && taken.includes(words[i - 1] ?? "")));
}

/** The words of the command line for what was set. Throws for a number that lacks its unit. */
export function wordsOf(settings: Setting[], values: Record<string, string>): string[] {
  return settings.flatMap(({ option, key, label, unit, isWords, isRepeated }) => {
    if (isWords) return shellWords(values[option] ?? "", label);
    const value = values[key ?? option]?.replace(/\s*,\s*/g, ",");
    if (!value) return [];
    // The program would take a bare number in SI units.
    const bare = value.split(/\s+|\.\.|:|@\S*/).find((part) => /^[-+]?(\d+[.,]?\d*|[.,]\d+)$/.test(part) && Number(part) !== 0);
    if (unit && bare !== undefined) throw new Error(`${label}: ${bare} has no unit. Write ${bare}${unit}, say.`);
    const words = value.split(/\s+/);
    return isRepeated ? words.flatMap((word) => [option, word]) : [option, ...words];
  });
}

/** A command as it can be pasted into a shell. */
export const shown = (words: string[]): string =>
  ["taut", ...words].map((word) => (/^[\w\-=+.,:/@%]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`)).join(" ");
