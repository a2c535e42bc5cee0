// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Made by types.mjs from src/results/result.schema.json: change that, then `npm run types`.

/**
 * A saved result of taut, version 1. All numbers are in SI units. Keys that are not named here may stand beside those that are.
 */
export type Result = Study | Identification | Comparison | Plan | Control;
export type Count = number;
export type SizeOrNull = number | null;
export type PartOrNull = number | null;
export type Size = number;
/**
 * @minItems 3
 * @maxItems 3
 */
export type Point = [number, number, number];
export type Points = Point[];
export type Index = number;
export type Indices = Index[];
/**
 * @minItems 2
 * @maxItems 2
 */
export type Pair = [Index, Index];
export type Numbers = number[];
export type Texts = string[];
export type Sizes = Size[];
/**
 * Those of the findings.
 */
export type Texts1 = string[];
/**
 * Of its edges or nodes, or of the uncertain parameter.
 */
export type Texts2 = string[];
/**
 * Edges and nodes that would explain it nearly as well.
 */
export type Texts3 = string[];
/**
 * What the checks of a result found, the worst first.
 */
export type Findings = {
  /**
   * What is wrong, or may be; docs/files.md has the value of each.
   */
  kind:
    | "no_convergence"
    | "survey_scale"
    | "survey_frame"
    | "survey_noise"
    | "prior"
    | "common_deviation"
    | "run_scales"
    | "length"
    | "slip"
    | "swapped_cables"
    | "adjustable_edge"
    | "support"
    | "boundary"
    | "target"
    | "adjacent_targets"
    | "swapped_targets"
    | "target_far_from_node"
    | "misplaced_names"
    | "predicted_form"
    | "slack_marks"
    | "force_scale"
    | "force_measurement"
    | "uncertain_parameter"
    | "tensions"
    | "length_change"
    | "turns"
    | "actuator_std"
    | "epoch"
    | "repeated_survey"
    | "other";
  /**
   * What this finding alone leads to.
   */
  severity: "passed" | "doubtful" | "failed";
  ids: Texts2;
  /**
   * In SI units.
   */
  value: number | null;
  /**
   * Standard deviation of the value.
   */
  std: number | null;
  confounded_with: Texts3;
  /**
   * What to identify again with.
   */
  remedy: {
    /**
     * As the option is named: "noise", "prior", "uncertain", "frame", "match".
     */
    parameter: string;
    /**
     * As the option reads it; empty: to be chosen.
     */
    value: string;
  } | null;
  reason: string;
  /**
   * What to do about it; may be empty.
   */
  next: string;
}[];
/**
 * Off the frame that was told, about the middle of the net [m]; 0 where it was unknown.
 *
 * @minItems 3
 * @maxItems 3
 */
export type Point1 = [number, number, number];
/**
 * [rad].
 *
 * @minItems 3
 * @maxItems 3
 */
export type Point2 = [number, number, number];
/**
 * @minItems 3
 * @maxItems 3
 */
export type PointOfSizes = [Size, Size, Size];
/**
 * Adjustable edges and supports that are not as designed; the worst first.
 */
export type Boundary = {
  edge?: Index;
  node?: Index;
  id: string;
  /**
   * Of an edge's length, or of a support's place [m].
   */
  deviation: number | Point;
  std: Size | PointOfSizes;
  statistic: number;
  /**
   * The support of the edge, or an edge at the support, that would explain it nearly as well.
   */
  rival: string | null;
}[];
/**
 * Since the net was as designed, until the last of several surveys.
 */
export type Turned = {
  edge: Index;
  id: string;
  /**
   * Change of the unstressed length [m].
   */
  stroke: number;
  /**
   * Play of the turnbuckle [m].
   */
  std: number;
}[];
/**
 * Since the survey before.
 */
export type Turned1 = {
  edge: Index;
  id: string;
  /**
   * Change of the unstressed length [m].
   */
  stroke: number;
  /**
   * Play of the turnbuckle [m].
   */
  std: number;
}[];
/**
 * "identified" and "unobserved" in files of 0.2.0.
 */
export type EdgeStatus = "determined" | "weakly determined" | "not determined" | "slack" | "identified" | "unobserved";
/**
 * Of all edges, in the predicted form [N].
 */
export type Sizes1 = Size[];
/**
 * Seen taut, though the survey tells otherwise: then nothing that was seen is used.
 */
export type Indices1 = Index[];
/**
 * Seen slack, likewise.
 */
export type Indices2 = Index[];
/**
 * What was found on reading it.
 */
export type Texts4 = string[];
export type CountOrNull = number | null;
/**
 * What forbids to turn by the plan, the worst first; the first lines of its lists.
 */
export type Texts5 = string[];
export type Verdict = "passed" | "doubtful" | "failed";
/**
 * Of each coordinate, over the draws; 0 without.
 */
export type Points1 = Point[];
/**
 * Unit normals of the target; 0 at nodes without.
 */
export type Points2 = Point[];

/**
 * Of taut reproduce. Lists over edges are in the order of the interior edges, lists over nodes in that of the free nodes, forms and tensions those of all nodes and edges.
 */
export interface Study {
  format: "taut-study";
  version: 1;
  program?: string;
  date?: string;
  command?: string;
  law?: string;
  seed?: number;
  net: Counts;
  samples: {
    total: Count;
    training: Count;
    validation: Count;
    with_slack: Count;
    not_converged: Count;
  };
  methods: {
    [k: string]: Method;
  };
  form_error: FormErrors;
  form_error_mean_over_validation?: FormErrors;
  forms_not_converged?: Count;
  paper?: {
    mse: Size;
    mrse: Size;
    form_error: FormErrors;
  };
  seconds: Seconds;
  cable_net: NetFile;
  nominal_form: Points;
  /**
   * The first validation sample.
   */
  sample: {
    index?: Index;
    true: Numbers;
    identified: Numbers;
    std: Numbers;
    true_form: Points;
    identified_form: Points;
    true_tension: Sizes;
    identified_tension: Sizes;
    form_error: {
      nominal: Numbers;
      identified: Numbers;
    };
  };
  /**
   * True less identified lengths over the validation samples.
   */
  errors: {
    mean: Numbers;
    std: Numbers;
    all?: Numbers[];
  };
}
export interface Counts {
  name?: string;
  free_nodes?: Count;
  supports?: Count;
  interior_edges?: Count;
  adjustable_edges?: Count;
  fingerprint?: string;
}
/**
 * The numbers of the lengths are null where the method failed throughout.
 */
export interface Method {
  surveys?: Count;
  failed?: Count;
  first_failure?: string;
  mse: SizeOrNull;
  mse_of_taut_edges?: SizeOrNull;
  mrse: SizeOrNull;
  error_mean_max_abs: SizeOrNull;
  error_std_mean: SizeOrNull;
  coverage_95?: PartOrNull;
  form_error?: FormErrorSummary | null;
  forms_not_converged?: Count;
  training_seconds?: Size;
  seconds?: Size;
}
/**
 * Distances between two forms over the free nodes [m].
 */
export interface FormErrorSummary {
  max: Size;
  min: Size;
  mean: Size;
  rmse: Size;
}
export interface FormErrors {
  nominal: FormErrorSummary;
  identified: FormErrorSummary;
}
export interface Seconds {
  sampling: Size;
  training: Size;
  identification: Size;
  total: Size;
}
/**
 * A net in taut's own format; its reader checks it further.
 */
export interface NetFile {
  format: "taut-net";
  version: 1;
  name?: string;
  nodes: Points;
  supports: Indices;
  edges: Pair[];
  axial_stiffness: number | Numbers;
  unstressed_lengths: Numbers;
  adjustable: Indices;
  loads?: Points;
  node_ids?: Texts;
  edge_ids?: Texts;
}
/**
 * Of taut identify.
 */
export interface Identification {
  format: "taut-identification";
  version: 1;
  program?: string;
  date?: string;
  command?: string;
  method: string;
  method_reason?: string;
  status?: string;
  trust?: Trust;
  findings?: Findings;
  doubt?: Doubt;
  /**
   * How far the net's supports are moved and turned in the survey's frame; null where that was told to be the net's.
   */
  frame_offset?: FrameOffset | null;
  turned?: Turned;
  /**
   * By survey, where there are several; else empty.
   */
  epochs?: Epoch[];
  /**
   * The most probable prior of the length deviations: "uniform:5mm".
   */
  law?: string;
  detectable?: Detectable;
  prior?: Prior;
  /**
   * What was taken as uncertain besides lengths.
   */
  assumptions?: Assumption[];
  /**
   * Root mean square of the stated standard deviations [m].
   */
  noise?: number;
  net_fingerprint?: string;
  net: Counts;
  edges: IdentifiedEdge[];
  form: Points;
  tension?: Sizes1;
  /**
   * Over all edges, of the posterior; null without draws [N].
   */
  mean_tension?: DrawnEstimate | null;
  /**
   * What else was unknown, and what the survey tells of it; of an edge or a node where one is named.
   */
  unknowns?: Unknown[];
  forces?: Forces;
  /**
   * Posterior covariances between the lengths of the edges that were asked for; null where none were.
   */
  length_covariance?: LengthCovariance | null;
  /**
   * What the draws tell of the adjustable edges; empty without.
   */
  adjustable_edges?: DrawnTension[];
  /**
   * What the draws tell of the nodes that the survey misses; empty without.
   */
  missing_places?: DrawnPlace[];
  /**
   * Of the posterior, kept in the HDF5 file beside the result; null where there are none.
   */
  draws?: Draws | null;
  /**
   * How the survey was brought into the net's frame; null where it was given in it.
   */
  frame?: Frame | null;
  survey: Survey;
  cable_net: NetFile;
}
/**
 * Whether the result may be acted on.
 */
export interface Trust {
  /**
   * The worst of all findings.
   */
  verdict: "passed" | "doubtful" | "failed";
  reasons?: Texts1;
}
/**
 * What the trust rests on, in numbers.
 */
export interface Doubt {
  noise: FoundScale;
  lengths: FoundScale;
  law: {
    /**
     * Of uniform, normal and bimodal ones; empty where too few lengths tell.
     */
    likeliest: string;
    /**
     * Of its log likelihood over that of the law reckoned with.
     */
    gain: number;
    /**
     * That it rests on.
     */
    lengths: number;
    /**
     * That all deviations have in common [m].
     */
    mean: number;
    mean_std: number;
    /**
     * Edges beyond the law, where they are too many to be mis-cut.
     */
    beyond: number;
    /**
     * Whether the law reckoned with was found from the survey.
     */
    found: boolean;
    /**
     * The law in whose place it was found: told, or the default.
     */
    contradicted: string | null;
  };
  /**
   * How the survey as a whole would fit better.
   */
  frame: {
    /**
     * By which it is too large, relative.
     */
    scale: number;
    /**
     * Of that, if it is not; 0 where the survey does not show it.
     */
    scale_std: number;
    translation: Point1;
    rotation: Point2;
    /**
     * Chi-squared of six degrees of freedom, if it is not moved.
     */
    motion_statistic: number;
  };
  boundary: Boundary;
  /**
   * Of the others, how many contradict the survey and were not set free.
   */
  boundary_beyond: number;
  lengths_beyond_law: {
    edge: Index;
    id: string;
    /**
     * By the survey alone [m].
     */
    deviation: number;
    std: number;
    statistic: number;
    /**
     * Edge that is as much shorter as this one is longer, or the reverse: a clamp slipped, or both were swapped.
     */
    other?: string;
    /**
     * Where both meet.
     */
    node?: string;
    /**
     * Whether each has the length of the other.
     */
    swapped?: boolean;
    /**
     * Whether the target at the node explains it as well, and is left out, too: deviation and std are those if it is right.
     */
    beside_target?: boolean;
  }[];
}
export interface FoundScale {
  /**
   * Found over told; 0 where the survey does not show it.
   */
  ratio: number;
  /**
   * Of the ratio, if what was told is true.
   */
  std: number;
}
/**
 * A rotation about a point, then a translation, both small [rad, m].
 */
export interface FrameOffset {
  about: Point;
  translation: Point;
  translation_std: PointOfSizes;
  rotation: Point;
  rotation_std: PointOfSizes;
}
/**
 * One survey among several of the same net.
 */
export interface Epoch {
  /**
   * Free nodes that were surveyed.
   */
  used: number;
  turned: Turned1;
  /**
   * Targets left out.
   */
  outliers: Outlier[];
  boundary?: Boundary;
  frame_offset?: FrameOffset | null;
  noise_ratio?: number;
  noise_scale?: number;
  /**
   * Root mean square of what its lengths differ by from those of the surveys before, over what all let expect; about 1. 0 of the first.
   */
  change_ratio: number;
  /**
   * Of change_ratio: chance exceeds it once in a thousand times.
   */
  change_limit?: number;
  /**
   * How far turns differ from what is told, beyond the play that is told of them; 0: no further [m].
   */
  untold_play?: number;
  /**
   * Lengths that changed since the survey before, but for what was turned; of the first survey: adjustable ones from what the net tells; the worst first.
   */
  changes: {
    edge: Index;
    id: string;
    change: number;
    std: number;
    statistic: number;
  }[];
  /**
   * By which all strokes would have to be multiplied to fit best; 1 where nothing was turned.
   */
  stroke_factor?: number;
  stroke_factor_std?: number;
  trust: Trust1;
  findings?: Findings;
}
/**
 * A target left out for a gross error.
 */
export interface Outlier {
  node: Index;
  id?: string;
  /**
   * Of the surveyed place from the one that all others tell [m].
   */
  distance?: number;
  /**
   * Its square in standard deviations, to be compared with outlier_threshold.
   */
  statistic?: number;
  /**
   * Name of the node whose target has this one's name, where two are swapped.
   */
  swapped_with?: string;
}
/**
 * Of this survey alone.
 */
export interface Trust1 {
  /**
   * The worst of all findings.
   */
  verdict: "passed" | "doubtful" | "failed";
  reasons?: Texts1;
}
/**
 * The smallest error of each kind, at a place drawn at random, that the checks find with a probability of 80 %; null: none is.
 */
export interface Detectable {
  /**
   * Distance of a target from its node [m].
   */
  target: number | null;
  /**
   * Of an interior edge [m].
   */
  length: number | null;
  /**
   * Length of an adjustable edge [m].
   */
  adjustable: number | null;
  /**
   * Distance of a support from its place [m].
   */
  support: number | null;
  /**
   * Of the survey, relative.
   */
  scale: number | null;
  /**
   * Of all interior edges [K].
   */
  temperature: number | null;
}
/**
 * Prior of the length deviations: as given, and as the survey shows it.
 */
export interface Prior {
  /**
   * "uniform:5mm"; null where none was given, and a broad one assumed.
   */
  given: string | null;
  /**
   * Taken as exact, not estimated.
   */
  exact: boolean;
  /**
   * Posterior mean of the standard deviation of a length deviation [m].
   */
  std: number;
  /**
   * Posterior standard deviation of that [m].
   */
  std_std: number;
  /**
   * Posterior probability of the uniform shape.
   */
  uniform_probability: number;
  common?: CommonDeviation;
  /**
   * The priors of the mixture, the most probable first.
   */
  nodes: PriorNode[];
}
/**
 * What the length deviations have in common, after the survey.
 */
export interface CommonDeviation {
  /**
   * Of all [m].
   */
  mean: number;
  /**
   * Of that; 0: taken to be none [m].
   */
  mean_std: number;
  /**
   * Runs of cable that were tried for a scale each.
   */
  runs: number;
  /**
   * Of the scales of runs, relative, posterior mean.
   */
  run_std: number;
  /**
   * That runs have such scales.
   */
  run_probability: number;
  /**
   * What all adjustable edges are longer than given [m].
   */
  adjustable?: number;
  /**
   * Of that; 0: their lengths are taken as given [m].
   */
  adjustable_std?: number;
}
export interface PriorNode {
  /**
   * "uniform:5mm", "normal:2mm".
   */
  law: string;
  /**
   * Posterior probability.
   */
  weight: number;
}
export interface Assumption {
  name: string;
  /**
   * As on the command line: "stiffness:5%".
   */
  value: string;
  /**
   * Of edges; null: all.
   */
  group: string | null;
  /**
   * Before the survey.
   */
  std: number;
  unit: string;
  /**
   * Whether it was given, or assumed by taut.
   */
  source: "given" | "default";
  /**
   * Whether the survey shows any number of it.
   */
  testable: boolean;
}
export interface IdentifiedEdge {
  edge: Index;
  id?: string;
  nodes?: Pair;
  /**
   * Unstressed length as designed [m].
   */
  nominal: number;
  /**
   * Estimate of true less nominal [m].
   */
  length_deviation: number;
  /**
   * Standard deviation of the estimate [m].
   */
  std: number;
  /**
   * 95 % interval of the deviation; all that is known of a slack edge [m].
   */
  lower: number;
  upper: number;
  status: EdgeStatus;
  /**
   * Mean over the draws; null without, as all below [N].
   */
  tension?: number | null;
  tension_std?: SizeOrNull;
  /**
   * 95 % interval [N].
   */
  tension_lower?: number | null;
  tension_upper?: SizeOrNull;
  slack_probability?: number | null;
}
/**
 * Mean, standard deviation and 95 % interval of a tension [N].
 */
export interface DrawnEstimate {
  mean: Size;
  std: Size;
  lower: Size;
  upper: Size;
}
export interface Unknown {
  name: string;
  /**
   * Of edges; null: all.
   */
  group: string | null;
  /**
   * "stiffness:5%", its standard deviation before the survey.
   */
  told: string;
  /**
   * Deviation from what the net tells; of a stiffness the logarithm of its factor.
   */
  mean: number;
  std: number;
  unit: string;
  /**
   * Before the survey, in that unit: of an assumed width 1.2 times that.
   */
  prior_std?: number;
  /**
   * Whether it is known better than before the survey.
   */
  observed: boolean;
  edge?: Index;
  node?: Index;
  axis?: "x" | "y" | "z";
  id?: string;
}
/**
 * What was told of forces besides the survey.
 */
export interface Forces {
  readings: Count;
  /**
   * Readings that contradict all else, and were left out.
   */
  outliers: {
    edge: Index;
    id: string;
    read: number;
    /**
     * By all else [N].
     */
    expected: number;
    statistic: number;
  }[];
  /**
   * Part by which all readings are too high against all else, where they were left out for it; else null.
   */
  bias?: {
    part: number;
    std: number;
  } | null;
  contradicted_taut?: Indices1;
  contradicted_slack?: Indices2;
}
export interface LengthCovariance {
  edges: Indices;
  ids: string[];
  /**
   * Row by row, in the order of edges [m2].
   */
  covariance: Numbers[];
}
export interface DrawnTension {
  edge: Index;
  id?: string;
  nodes?: Pair;
  tension: SizeOrNull;
  tension_std: SizeOrNull;
  tension_lower: SizeOrNull;
  tension_upper: SizeOrNull;
  slack_probability: number | null;
}
/**
 * Mean, standard deviation and 95 % interval of each coordinate [m].
 */
export interface DrawnPlace {
  node: Index;
  mean: Point;
  std: PointOfSizes;
  lower: Point;
  upper: Point;
}
export interface Draws {
  count: Count;
  /**
   * Of what was drawn, by which the file is known to belong to the result.
   */
  fingerprint?: string;
  seed: number;
  how: string;
  /**
   * Why they are not to be relied on; null where they are.
   */
  doubt: string | null;
}
/**
 * The rigid motion x -> rotation (x - from) + to from the instrument's frame to the net's.
 */
export interface Frame {
  /**
   * Rows of the matrix.
   *
   * @minItems 3
   * @maxItems 3
   */
  rotation: [Point, Point, Point];
  from: Point;
  to: Point;
  fit: {
    /**
     * Of the lengths of the control points' residuals [m].
     */
    rms: number;
    count: Count;
  };
  control: ControlResidual[];
}
/**
 * Measured, moved into the net's frame, less known [m].
 */
export interface ControlResidual {
  id: string;
  dx: number;
  dy: number;
  dz: number;
}
export interface Survey {
  used: Count;
  missing: Count;
  noise?: Size;
  /**
   * Residuals over what the noise lets expect; 0 where not computed.
   */
  noise_ratio?: number;
  outliers: Outlier[];
  outlier_threshold?: number;
  /**
   * Of the targets that were not left out [m].
   */
  rms_residual: number;
  max_residual: number;
  residuals?: Residual[];
  missing_nodes?: Indices;
  unmatched?: Unmatched[];
  /**
   * As in frame, for readers that do not know it.
   */
  control?: ControlResidual[];
  warnings?: Texts4;
}
/**
 * Surveyed less predicted [m].
 */
export interface Residual {
  node: Index;
  dx: number;
  dy: number;
  dz: number;
  standardised?: Point | null;
}
/**
 * A target that was put on no node.
 */
export interface Unmatched {
  id: string;
  line?: Count;
  reason?: string;
  /**
   * Name of a node.
   */
  nearest?: string;
  distance?: Size;
  /**
   * Name of the node whose target has this one's name, where two are swapped.
   */
  swapped_with?: string;
}
/**
 * Of taut compare.
 */
export interface Comparison {
  format: "taut-comparison";
  version: 1;
  program?: string;
  date?: string;
  command?: string;
  law?: string;
  seed?: number;
  net: Counts;
  common_noise?: Size;
  common_training_samples?: CountOrNull;
  samples?: {
    total: Count;
    not_converged: Count;
    surveyed: Count;
    surveyed_with_slack: Count;
  };
  seconds?: Seconds;
  /**
   * @minItems 1
   */
  rows: [ComparisonRow, ...ComparisonRow[]];
  /**
   * Besides the lengths: ["supports:1mm"].
   */
  unknowns?: string[];
  /**
   * On nets that differ from the design in these.
   */
  model_error_rows?: ComparisonRow[];
  /**
   * By several surveys of each net at once.
   */
  epoch_rows?: ComparisonRow[];
}
/**
 * One method at one noise, training size and part of hidden nodes. What the method does not have is null.
 */
export interface ComparisonRow {
  method: string;
  /**
   * Standard deviation of a surveyed coordinate [m].
   */
  noise: number;
  hidden_fraction?: PartOrNull;
  /**
   * Surveys of each net that are used at once.
   */
  epochs?: number;
  /**
   * Whether edges were turned between them.
   */
  turned?: boolean;
  /**
   * Whether the surveyed nets differ from the design in more than lengths, and whether the method was told in what.
   */
  model_errors?: "none" | "untold" | "told";
  training_samples?: CountOrNull;
  surveys?: CountOrNull;
  failed?: CountOrNull;
  first_failure?: string | null;
  mse?: SizeOrNull;
  best_possible_mse?: SizeOrNull;
  mse_of_taut_edges?: SizeOrNull;
  best_possible_mse_of_taut_edges?: SizeOrNull;
  mrse?: SizeOrNull;
  form_error?: SizeOrNull;
  forms_not_converged?: CountOrNull;
  coverage?: PartOrNull;
  training_seconds?: SizeOrNull;
  seconds?: SizeOrNull;
}
/**
 * Of taut plan: which turnbuckle to turn how far, in which order, and what follows.
 */
export interface Plan {
  format: "taut-plan";
  version: 1;
  program?: string;
  date?: string;
  command?: string;
  net_fingerprint: string;
  net: Counts;
  warnings?: Texts5;
  /**
   * Trust in the result that the plan stands on.
   */
  identification: {
    verdict: Verdict;
    reasons: Texts;
  };
  /**
   * In the order of the work.
   */
  turns: Turn[];
  /**
   * Edges that are turned.
   */
  touched: number;
  /**
   * [m].
   */
  largest_stroke: number;
  /**
   * Whether forces were limited beyond that no edge goes slack.
   */
  limits_given?: boolean;
  /**
   * Whether all limits are kept with the confidence wanted.
   */
  feasible: boolean;
  converged: boolean;
  /**
   * Limits that are not kept, or not surely so; the worst first.
   */
  violations: LimitBreach[];
  form: {
    as_built: FormDeviation;
    planned: FormDeviation;
    unavoidable: FormDeviation1;
    /**
     * What of the planned deviation along the normal is not known yet, RMS over nodes and draws; 0 without [m].
     */
    normal_unknown: number;
  };
  /**
   * [N].
   */
  tension: {
    least: Size;
    most: Size;
    least_as_built: Size;
    most_as_built: Size;
    /**
     * That all limits are kept; null without draws (0 or 1 in files of 0.2.0).
     */
    limit_probability: number | null;
    /**
     * Of all edges, in their order.
     */
    edges: PlannedTension[];
  };
  order: {
    /**
     * Over the net.
     */
    passes: number;
    crews: Count;
    /**
     * Of all crews, along straight lines between stations [m].
     */
    walk: number;
    /**
     * Whether at no step a limit is broken that was kept before the work, with the confidence wanted.
     */
    safe: boolean;
    /**
     * That at no step a limit is broken that was kept before; 0 or 1 without draws.
     */
    safe_probability?: number;
    /**
     * When it is worst, where it is not safe.
     */
    worst: {
      moment: Index;
      breach: LimitBreach;
    } | null;
  };
  options: {
    target?: "form" | "surface";
    /**
     * Of the deviation of each free node.
     */
    node_weights?: {
      normal: Sizes;
      tangential: Sizes;
    };
    confidence: number;
    /**
     * Standard deviation of what is turned from what was told [m].
     */
    actuator: number;
    /**
     * Change of length by one turn; null where that was not told [m].
     */
    pitch: number | null;
    /**
     * By the smallest part of a turn; 0: any [m].
     */
    step: number | null;
    /**
     * [m].
     */
    tolerance: number | null;
    /**
     * Of the turnbuckles; null where it was not told.
     */
    thread: "right" | "left" | null;
  };
  /**
   * What whole steps of a turn cost.
   */
  whole_steps: {
    /**
     * [m].
     */
    normal_rmse_of_free_strokes: number;
  };
  /**
   * Both null where none was told.
   */
  tolerance: {
    reached: boolean | null;
    /**
     * Edges below which, to first order, it cannot be reached.
     */
    fewest_bound: number | null;
  };
  /**
   * Edges that would help most if they could be turned, too, each with those before it; null where it was not asked.
   */
  further?:
    | {
        edge: Index;
        edge_id: string;
        stroke: number;
        normal_rmse_after: number;
      }[]
    | null;
  /**
   * Targets that would tell of the planned form what is not known yet; null where it was not asked.
   */
  survey_first?: {
    noise: number;
    targets: {
      node: Index;
      id: string;
      /**
       * What is left with this and those before, root mean square [m].
       */
      normal_unknown: number;
    }[];
  } | null;
  draws: Count;
  /**
   * Why there are none; null where there are.
   */
  no_draws_since: string | null;
  built_form: Points;
  planned_form: Points;
  planned_form_std: Points1;
  target_form: Points;
  target_normals: Points2;
  cable_net: NetFile1;
}
/**
 * One thing that a crew does at one turnbuckle.
 */
export interface Turn {
  edge: Index;
  edge_id: string;
  /**
   * Change of the unstressed length, positive lengthens [m].
   */
  stroke: number;
  /**
   * Without sign; null where the pitch was not told.
   */
  turns: number | null;
  sense: "shorten" | "lengthen";
  /**
   * Seen from the support along the cable; null where the thread was not told.
   */
  rotation: "clockwise" | "counterclockwise" | null;
  /**
   * From 1.
   */
  pass: number;
  /**
   * From 1.
   */
  crew: number;
  /**
   * Those of one moment are turned at once; from 0.
   */
  moment: number;
  /**
   * Unstressed length then, less the designed one [m].
   */
  reading_after: number;
  /**
   * When all is done [N].
   */
  tension_after: number;
}
export interface LimitBreach {
  kind: "tension" | "reaction";
  /**
   * Of a tension.
   */
  edge?: number;
  /**
   * The support of a reaction.
   */
  node?: number;
  id: string;
  /**
   * Null: the loads of the net.
   */
  load_case: string | null;
  /**
   * Planned [N].
   */
  value: number;
  /**
   * [N].
   */
  limit: number;
  /**
   * That the limit is kept; 0 or 1 without draws.
   */
  probability: number;
}
/**
 * Distances from the target over the free nodes, and along its normal over those that have one [m].
 */
export interface FormDeviation {
  mean: Size;
  max: Size;
  rmse: Size;
  normal_mean: Size;
  normal_max: Size;
  normal_rmse: Size;
}
/**
 * Distances from the target over the free nodes, and along its normal over those that have one [m].
 */
export interface FormDeviation1 {
  mean: Size;
  max: Size;
  rmse: Size;
  normal_mean: Size;
  normal_max: Size;
  normal_rmse: Size;
}
/**
 * Of an edge [N].
 */
export interface PlannedTension {
  edge: Index;
  as_built: Size;
  planned: Size;
  /**
   * 95 % interval over the draws; null without.
   */
  lower: number | null;
  upper: SizeOrNull;
  limit_lower: Size;
  /**
   * Null: none.
   */
  limit_upper: number | null;
}
/**
 * A net in taut's own format; its reader checks it further.
 */
export interface NetFile1 {
  format: "taut-net";
  version: 1;
  name?: string;
  nodes: Points;
  supports: Indices;
  edges: Pair[];
  axial_stiffness: number | Numbers;
  unstressed_lengths: Numbers;
  adjustable: Indices;
  loads?: Points;
  node_ids?: Texts;
  edge_ids?: Texts;
}
/**
 * Of taut control: simulated jobs of surveys and turns, by what the turns are planned on.
 */
export interface Control {
  format: "taut-control";
  version: 1;
  program?: string;
  date?: string;
  command?: string;
  net_fingerprint?: string;
  net: Counts;
  settings: {
    /**
     * Of the length deviations that are built.
     */
    law: string;
    /**
     * What else is built with values of its own: ["stiffness:5%"]; nothing in files of version 0.2.
     */
    uncertain?: string[];
    /**
     * Standard deviation of a surveyed coordinate [m].
     */
    noise: number;
    /**
     * Part of the free nodes that each survey misses.
     */
    hidden: number;
    /**
     * Standard deviation of what is turned from what was told [m].
     */
    actuator: number;
    /**
     * Of a turnbuckle since installation, either way [m].
     */
    stroke: number;
    /**
     * [N].
     */
    least_tension: number;
    /**
     * Null: no limit [N].
     */
    most_tension: number | null;
    /**
     * With which limits are to hold, of plans on identified lengths.
     */
    confidence: number;
    /**
     * By the smallest part of a turn; null: any [m].
     */
    step: number | null;
    /**
     * Of each identification.
     */
    draws: number;
    rounds: Count;
    /**
     * Nets that are built.
     */
    trials: number;
    seed: number;
  };
  /**
   * @minItems 1
   */
  strategies: [ControlStrategy, ...ControlStrategy[]];
}
export interface ControlStrategy {
  /**
   * What turns are planned on.
   */
  strategy: "true lengths" | "identified" | "design" | "design, once";
  /**
   * Over the trials, from round 0.
   */
  rounds: ControlRound[];
  /**
   * By trial, then round.
   */
  states: ControlState[];
}
/**
 * The true nets after a round; round 0 is as built. Distances are from the target over the free nodes, and along its normal [m].
 */
export interface ControlRound {
  round: Count;
  mean: Size;
  /**
   * The most in any trial.
   */
  max: number;
  normal_mean: Size;
  normal_max: Size;
  /**
   * Over nodes and trials.
   */
  normal_rmse: number;
  /**
   * In any trial [N].
   */
  least_tension: number;
  /**
   * In any trial [N].
   */
  most_tension: number;
  /**
   * With an edge beyond its limits.
   */
  broken_trials: number;
  /**
   * By how much a limit is broken at most, as a part of it.
   */
  worst_excess: number;
  /**
   * Sum of the sizes of the strokes of this round, mean over the trials [m].
   */
  turned: number;
  /**
   * Trials in which no identification or plan came about: nothing was turned.
   */
  failed: number;
}
/**
 * The true net of a trial after a round.
 */
export interface ControlState {
  trial: Index;
  round: Count;
  mean: Size;
  max: Size;
  normal_mean: Size;
  normal_max: Size;
  normal_rmse: Size;
  least_tension: Size;
  most_tension: Size;
  /**
   * Edges beyond their limits.
   */
  broken: number;
  worst_excess: Size;
  turned: Size;
  failed: boolean;
}
