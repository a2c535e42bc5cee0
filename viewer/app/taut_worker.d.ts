// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

/** worker.ts, bundled: build_app.mjs. */
declare module "taut:worker" {
  const source: string;
  export default source;
}
