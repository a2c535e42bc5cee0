// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { counted, millimetres, number, percent, short } from "./format";
import { methodsOf, type Study } from "./result";
import { nameOf, netWords, priorWords, type Summary } from "./summary_words";

/** "17 times smaller". */
function times(before: number, after: number): string {
  if (!(before > 0) || !(after > 0)) return "";
  const [ratio, word] = before >= after ? [before / after, "smaller"] : [after / before, "larger"];
  return `${short(Number(ratio.toPrecision(2)))} times ${word}`;
}

export function ofStudy(study: Study): Summary {
  const [name, method] = methodsOf(study)[0]!;
  const error = 1e3 * Math.sqrt(method.mse ?? NaN);
  const { nominal, identified } = study.form_error;
  const { total, training, validation, with_slack } = study.samples;
  const ratio = times(nominal.mean, identified.mean);
  return {
    title: "Unstressed lengths of the cables, identified from the form",
    done:
      `A numerical experiment on the net ${nameOf(study.net)}: ${netWords(study.net)}. In ${counted(total, "sample")} the lengths of its interior cables deviate ` +
      `${priorWords(study.prior)} from the design. Gaussian processes were trained on ${training} of the forms and validated on ${validation} others.`,
    sentences: [
      `The error of an identified length is ${number(error)} mm (RMS over all cables and validation samples). ${percent(method.mrse)} % of the squared deviation remains.`,
      `The form predicted with the identified lengths is ${millimetres(identified.mean)} mm from the true one (mean; max ${millimetres(identified.max)} mm). With the design lengths it is ${millimetres(nominal.mean)} mm${ratio ? `; the error is ${ratio}` : ""}.`,
      method.coverage_95 == null
        ? `The largest mean error of a cable over the validation samples is ${millimetres(method.error_mean_max_abs)} mm.`
        : `${method.coverage_95 > 0.9 ? "The reported uncertainty holds" : "The reported uncertainty is too small"}: ${percent(method.coverage_95)} % of the true lengths lie in their 95 % interval.` +
          (with_slack > 0 ? ` In ${with_slack} of ${counted(total, "sample")} some cable went slack; the form does not show the length of such a cable.` : ""),
    ],
    figures: [
      { value: number(error), unit: "mm", label: "error of a length, RMS" },
      { value: percent(method.mrse), unit: "%", label: "of the squared deviation remains (MRSE)" },
      { value: millimetres(nominal.mean), unit: "mm", label: "form error as designed, mean" },
      { value: millimetres(identified.mean), unit: "mm", label: "form error as identified, mean" },
      { value: percent(method.coverage_95), unit: "%", label: `in 95 % intervals (${name === "gp_as_in_paper" ? "method as in the paper" : name})` },
    ],
  };
}
