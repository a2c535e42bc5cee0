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

/** The job that was kept last; undefined where there is none, or where the browser keeps nothing. */
export async function keptJob(): Promise<Job | undefined> {
  try {
    return (await done((await jobs("readonly")).get(key))) as Job | undefined;
  } catch {
    return undefined;
  }
}

/** Whether the job is kept. */
export async function keep(job: Job): Promise<boolean> {
  try {
    const { transaction } = (await jobs("readwrite")).put(job, key);
    // Only then it is on the disk.
    await new Promise((resolve, reject) => Object.assign(transaction!, { oncomplete: resolve, onabort: reject, onerror: reject }));
    return true;
  } catch {
    return false;
  }
}
