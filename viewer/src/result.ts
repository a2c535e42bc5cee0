// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// The results as taut writes them (docs/files.md), in SI units. taut has checked them before it
// made the page.

type Point = [number, number, number];

export interface NetFile {
  name?: string;
  nodes: Point[];
  supports: number[];
  edges: [number, number][];
  axial_stiffness: number | number[];
  unstressed_lengths: number[];
  adjustable: number[];
  node_ids?: string[];
  edge_ids?: string[];
}

export interface Counts {
  name?: string;
  free_nodes?: number;
  supports?: number;
  interior_edges?: number;
  adjustable_edges?: number;
  fingerprint?: string;
}

interface Head {
  version: number;
  program?: string;
  date?: string;
  command?: string;
  law?: string;
  seed?: number;
  net: Counts;
}

export interface FormErrorSummary {
  max: number;
  min: number;
  mean: number;
  rmse: number;
}

export interface FormErrors {
  nominal: FormErrorSummary;
  identified: FormErrorSummary;
}

/** A number is null where the method gave no lengths. */
export interface Method {
  surveys?: number;
  failed?: number;
  first_failure?: string;
  mse: number | null;
  mrse: number | null;
  error_mean_max_abs: number | null;
  error_std_mean: number | null;
  coverage_95?: number | null;
  form_error?: FormErrorSummary | null;
  training_seconds?: number;
  seconds?: number;
}

export interface Study extends Head {
  format: "taut-study";
  cable_net: NetFile;
  samples: { total: number; training: number; validation: number; with_slack: number; not_converged: number };
  methods: Record<string, Method>;
  form_error: FormErrors;
  form_error_mean_over_validation?: FormErrors;
  forms_not_converged?: number;
  paper?: { mse: number; mrse: number; form_error: FormErrors };
  seconds: Record<string, number>;
  nominal_form: Point[];
  sample: {
    true: number[];
    identified: number[];
    std: number[];
    true_form: Point[];
    identified_form: Point[];
    true_tension: number[];
    identified_tension: number[];
    form_error: { nominal: number[]; identified: number[] };
  };
  errors: { mean: number[]; std: number[]; all?: number[][] };
}

/** The methods of a study: first the one that its lengths and forms are of. */
export function methodsOf(study: Study): [string, Method][] {
  const first = "gp_as_in_paper";
  return Object.entries(study.methods).sort(([a], [b]) => Number(b === first) - Number(a === first));
}

export type EdgeStatus = "identified" | "slack" | "unobserved";

export interface Outlier {
  node: number;
  id?: string;
  statistic?: number | null;
}

export interface Identification extends Head {
  format: "taut-identification";
  cable_net: NetFile;
  method: string;
  method_reason?: string;
  noise?: number | string | null;
  edges: {
    edge: number;
    nominal: number;
    length_deviation: number;
    std: number;
    lower: number;
    upper: number;
    status: EdgeStatus;
  }[];
  form: Point[];
  tension?: number[];
  survey: {
    used: number;
    missing: number;
    outliers: Outlier[];
    rms_residual: number;
    max_residual: number;
    missing_nodes?: number[];
    unmatched?: unknown[];
    residuals?: { node: number; dx: number; dy: number; dz: number; standardised?: Point | null }[];
  };
}

export interface ComparisonRow {
  method: string;
  noise: number;
  training_samples?: number | null;
  hidden_fraction?: number | null;
  mse?: number | null;
  mrse?: number | null;
  form_error?: number | null;
  coverage?: number | null;
  training_seconds?: number | null;
  seconds?: number | null;
  surveys?: number | null;
  failed?: number | null;
  first_failure?: string | null;
  mse_of_taut_edges?: number | null;
  best_possible_mse?: number | null;
}

export interface Comparison extends Head {
  format: "taut-comparison";
  samples?: { total: number; not_converged: number; surveyed: number; surveyed_with_slack: number };
  seconds?: Record<string, number>;
  rows: ComparisonRow[];
}

export type Result = Study | Identification | Comparison;

/** The result inside the page. Throws with words for the reader where it is not one. */
export function readResult(text: string): Result {
  const result = JSON.parse(text) as Result;
  const known = ["taut-study", "taut-identification", "taut-comparison"];
  if (!known.includes(result?.format)) throw new Error(`its format is not one of ${known.join(", ")}`);
  if (result.version !== 1) throw new Error(`its version is ${String(result.version)}, this page knows version 1`);
  return result;
}
