// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** Significant digits with a true minus sign: "0.0123", "4.56", "1234", "1.70×10⁻⁸"; a dash for none. */
export function number(value: number | null | undefined, digits = 3): string {
  if (value == null || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const [mantissa, power] = value.toExponential(digits - 1).split("e") as [string, string];
  const exponent = Number(power);
  if (exponent < -3 || exponent > 5) {
    const raised = [...String(Math.abs(exponent))].map((d) => superscripts[Number(d)]).join("");
    return `${mantissa}×10${exponent < 0 ? "⁻" : ""}${raised}`.replace("-", "−");
  }
  return value.toFixed(Math.max(0, digits - 1 - exponent)).replace("-", "−");
}

/** The same without zeros at the end of a fraction, for what was set or published. */
export function short(value: number | null | undefined): string {
  const [mantissa, power] = number(value).split("×") as [string, string?];
  const plain = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
  return power ? `${plain}×${power}` : plain;
}

/** With a fixed number of decimals, for columns. */
export function fixed(value: number, decimals: number): string {
  return Number.isFinite(value) ? value.toFixed(decimals).replace("-", "−") : "–";
}

export const millimetres = (metres: number | null | undefined): string => number(1e3 * (metres ?? NaN));
export const percent = (part: number | null | undefined): string => number(1e2 * (part ?? NaN));

/** "× 1.5", "× 240". */
export const factorText = (factor: number): string => `× ${factor < 10 ? factor.toFixed(1) : Math.round(factor)}`;

/** A count with its noun: "1 edge", "536 edges". */
export function counted(count: number, noun: string): string {
  const text = count < 10_000 ? String(count) : count.toLocaleString("en").replaceAll(",", "\u202f");
  return `${text} ${noun}${count === 1 ? "" : "s"}`;
}

/** "2 targets excluded as gross errors". */
export const excludedTargets = (count: number): string => `${counted(count, "target")} excluded as ${count === 1 ? "a gross error" : "gross errors"}`;

/** NaN of none. */
export const rootMeanSquare = (values: number[]): number => Math.sqrt(values.reduce((sum, v) => sum + v * v, 0) / values.length);

/** The largest of 1, 2 or 5 times a power of ten that is no larger. */
export function nice(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}
