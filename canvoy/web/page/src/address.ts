// The shown view is in the address, after its #: Back goes back, a reload shows the same, and a
// link shows it to others.
//
//     #view=frames&filter=node%3D10&at=12.5&pin=sim0+10+6060:00&seed=1&fault=...
//
// `at` is present while time stands, in seconds since the start; seed, faults and acts (what people
// did) are those of the run.
import { useEffect, useState } from "preact/hooks";

export type Part = "view" | "filter" | "frame" | "search" | "node" | "list" | "object" | "sort" | "zoom" | "at";

const listeners = new Set<() => void>();

const parts = () => new URLSearchParams(location.hash.slice(1));
export const part = (name: Part) => parts().get(name) ?? "";
/** Lists in the address: pins, and what the run has had. */
export type ListPart = "pin" | "fault" | "act";
export const parts_of = (name: ListPart) => parts().getAll(name);
/** The run in the address; none without a seed. */
export const asked_seed = () => parts().get("seed");

function write(all: URLSearchParams, is_new: boolean) {
  const made = new URLSearchParams([...all].filter(([, value]) => value !== ""));
  const text = `${made}`;
  if (text === `${parts()}`) return;
  const url = `${location.pathname}${location.search}${text && "#"}${text}`;
  // What is ours is not asked about when Back leads to it.
  if (is_new) history.pushState({ own: true }, "", url);
  else history.replaceState({ own: true }, "", url);
  listeners.forEach((listener) => listener());
}

function changed(changes: Partial<Record<Part, string>>): URLSearchParams {
  const made = parts();
  for (const [name, value] of Object.entries(changes)) made.set(name, value);
  return made;
}

/** Goes to another place, which Back leaves. */
export const go = (changes: Partial<Record<Part, string>>) => write(changed(changes), true);
/** Adds details to the present place: what is typed, picked or pinned. */
export const refine = (changes: Partial<Record<Part, string>>) => write(changed(changes), false);

export function refine_lists(lists: Partial<Record<ListPart, string[]>>, also: [string, string][] = []) {
  const made = parts();
  for (const [name, values] of Object.entries(lists)) {
    made.delete(name);
    values.forEach((value) => made.append(name, value));
  }
  also.forEach(([key, value]) => made.set(key, value));
  write(made, false);
}

/** The part after the # of a link to the shown view, at a time. */
export function link_hash(at: string | undefined): string {
  const made = changed(at === undefined ? {} : { at });
  return `${made}` && `#${made}`;
}

/** `asked`: the address comes from elsewhere; else from Back or Forward. */
export function watch_address(done: (asked: boolean) => void): () => void {
  const look = (event: PopStateEvent) => {
    listeners.forEach((listener) => listener());
    done(!event.state?.own);
  };
  addEventListener("popstate", look);
  return () => removeEventListener("popstate", look);
}

/** Draws a component again when the address has changed. */
export function useAddress() {
  const [, set] = useState(0);
  useEffect(() => {
    const listener = () => set((n) => n + 1);
    listeners.add(listener);
    return () => void listeners.delete(listener);
  }, []);
  return part;
}
