// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The job in the browser's own storage, so that a closed tab loses nothing.

import type { Job } from "./job";

const table = "jobs";
const key = "current";

function done<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser's storage failed"));
  });
}

let opened: Promise<IDBDatabase> | undefined;

async function jobs(mode: IDBTransactionMode): Promise<IDBObjectStore> {
  opened ??= (() => {
    const request = indexedDB.open("taut", 1);
    request.onupgradeneeded = () => request.result.createObjectStore(table);
    return done(request);
  })();
  return (await opened).transaction(table, mode).objectStore(table);
}

/** Each tab that keeps a job marks it as its own. */
type Kept = Job & { mark?: string };
let mark: string | undefined;

/** The job that was kept last; undefined where there is none, or where the browser keeps nothing. */
export async function keptJob(): Promise<Job | undefined> {
  try {
    const kept = (await done((await jobs("readonly")).get(key))) as Kept | undefined;
    mark = kept?.mark;
    return kept;
  } catch {
    return undefined;
  }
}

/** Whether the job is kept: not where another tab kept its own since. */
export async function keep(job: Job): Promise<"kept" | "other" | "nothing"> {
  try {
    const store = await jobs("readwrite");
    const before = (await done(store.get(key))) as Kept | undefined;
    if (before !== undefined && before.mark !== mark) return "other";
    mark = `${Date.now()} ${Math.random()}`;
    const { transaction } = store.put({ ...job, mark }, key);
    // Only then it is on the disk.
    await new Promise((resolve, reject) => Object.assign(transaction!, { oncomplete: resolve, onabort: reject, onerror: reject }));
    return "kept";
  } catch {
    return "nothing";
  }
}
