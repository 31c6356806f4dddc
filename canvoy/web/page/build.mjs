// Builds the page into built/, of which the program takes its files: npm run build.
import { build } from "esbuild";
import { cpSync, readFileSync, writeFileSync } from "node:fs";

const out = process.argv[2] ?? "built";
await build({
  entryPoints: { page: "src/main.tsx", report: "src/report.tsx" },
  bundle: true,
  minify: true,
  charset: "utf8",
  legalComments: "none",
  format: "iife",
  target: ["chrome110", "firefox115"],
  jsx: "automatic",
  jsxImportSource: "preact",
  banner: {
    js: "/* Canvoy's page and reports, built from canvoy/web/page; with Preact (MIT) */",
  },
  outdir: out,
  logLevel: "warning",
});
/** The rules of a minified style whose classes all stand among the words: those of others never match. */
function used_rules(style, words) {
  const is_word = (name) => words.has(name) || words.has(name.replace(/[^-]*$/, ""));  // `band-${number}`
  const is_used = (selector) => (selector.match(/(?<=\.)[a-z][\w-]*/gi) ?? []).every(is_word);
  let kept = "";
  for (let at = 0; at < style.length; ) {
    const open = style.indexOf("{", at);
    if (open < 0) break;
    let end = open + 1;
    for (let depth = 1; depth > 0; ++end) depth += { "{": 1, "}": -1 }[style[end]] ?? 0;
    const head = style.slice(at, open);
    const body = style.slice(open + 1, end - 1);
    if (/^@(media|supports)/.test(head)) {
      const inside = used_rules(body, words);
      if (inside) kept += `${head}{${inside}}`;
    } else if (head.startsWith("@")) {
      kept += style.slice(at, end);
    } else {
      const selectors = head.split(/,(?![^(]*\))/).filter(is_used);
      if (selectors.length) kept += `${selectors.join(",")}{${body}}`;
    }
    at = end;
  }
  return kept;
}
// A report has the rules of what it shows: it is to be small enough for a mail.
const of_report = [`${out}/report.js`, "src/report.html", "../../tools/page/report_text.cpp", "../../tools/page/report_page.cpp"];
const words = new Set(of_report.flatMap((file) => readFileSync(file, "utf8").match(/[a-z][\w-]*/gi)));
writeFileSync(`${out}/report.css`, used_rules(readFileSync(`${out}/page.css`, "utf8").replace(/^\/\*.*?\*\/\s*/s, "").trim(), words));
// Of the view of plots alone, which loads it when it is opened.
cpSync("node_modules/uplot/dist/uPlot.iife.min.js", `${out}/uplot.js`);
for (const file of ["index.html", "report.html", "icon.svg"]) cpSync(`src/${file}`, `${out}/${file}`);
