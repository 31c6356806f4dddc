// What is to fit, and how that is seen: the worlds, views and sizes of the sweep, and what a page is asked for.

export const sizes = [[390, 844], [844, 390], [768, 1024], [1024, 768], [1280, 720], [1920, 1080]];
export const views = ["World", "Nodes", "Objects", "Frames", "Plots", "Load", "Events"];
export const worlds = {
  lift: ["run", "lift", "--lifts", "8", "--floors", "30", "--web", "--speed", "20"],
  charger: ["run", "charger", "--web", "--speed", "60"],
  yard: ["run", "charger", "--chargers", "16", "--batteries", "24", "--goal", "80@06:00", "--web", "--speed", "60"],
  taxi: ["run", "taxi", "--web", "--speed", "60"],
  police: ["run", "police", "--web", "--speed", "60"],
  bus: ["run", "bus", "--web", "--speed", "60"],
  excavator: ["run", "excavator", "--web", "--speed", "10"],
};

/** Runs in the page. Sentences of what reaches beyond an edge, is too small for a finger, or cannot be read; empty: all fits. */
export function misfits() {
  const least_target = 24; // CSS pixels: WCAG 2.2, 2.5.8
  const least_text = 11;
  const told = [];
  const name = (element) => `${element.tagName.toLowerCase()}.${element.getAttribute("class") ?? ""} "${(element.innerText ?? element.textContent ?? "").trim().slice(0, 30)}"`;
  const is_seen = (element, box) => box.width > 0 && box.height > 0 && getComputedStyle(element).visibility !== "hidden";
  /** What has a bar to scroll shows the rest by it. */
  const scrolls = (element) => {
    for (let each = element.parentElement; each && each.id !== "page"; each = each.parentElement) {
      if (each.tagName !== "MAIN" && /auto|scroll/.test(getComputedStyle(each).overflowX)) return true;
    }
    return false;
  };
  if (document.documentElement.scrollWidth > innerWidth) told.push(`the page is ${document.documentElement.scrollWidth - innerWidth} pixels wider than its window`);
  if (document.documentElement.scrollHeight > innerHeight + 1) told.push(`the page is ${document.documentElement.scrollHeight - innerHeight} pixels higher than its window`);
  const main = document.querySelector("main");
  if (main.scrollWidth > main.clientWidth + 1) told.push(`the view is ${main.scrollWidth - main.clientWidth} pixels wider than its room`);
  for (const element of document.querySelectorAll("#page *")) {
    const box = element.getBoundingClientRect();
    if (element.closest(".skip, svg *") || !is_seen(element, box) || scrolls(element)) continue;
    if (box.right > innerWidth + 1 || box.left < -1) told.push(`${name(element)} reaches from ${box.left.toFixed(0)} to ${box.right.toFixed(0)} of ${innerWidth}`);
  }
  for (const element of document.querySelectorAll("#page button, #page a, #page input, #page select, #page summary, #page [role=button]")) {
    const box = element.getBoundingClientRect();
    if (element.closest(".skip") || !is_seen(element, box)) continue;
    const of_label = element.type === "checkbox" ? element.closest("label").getBoundingClientRect() : box;
    if (of_label.width < least_target - 0.5 || of_label.height < least_target - 0.5) told.push(`${name(element)} is a target of ${of_label.width.toFixed(0)} x ${of_label.height.toFixed(0)}`);
  }
  const sees = main.getBoundingClientRect();
  if (sees.height < 150) told.push(`the view has ${sees.height.toFixed(0)} pixels of height`);
  for (const element of document.querySelectorAll("main svg text")) {
    const box = element.getBoundingClientRect();
    const scale = element.getScreenCTM()?.a ?? 1;
    const size = parseFloat(getComputedStyle(element).fontSize) * scale;
    if (is_seen(element, box) && size < least_text - 0.5) told.push(`text "${element.textContent}" is ${size.toFixed(1)} pixels high`);
  }
  return [...new Set(told)].slice(0, 8);
}
