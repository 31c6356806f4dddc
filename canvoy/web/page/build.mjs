// Builds the page into built/, of which the program takes its files: npm run build.
import { build } from "esbuild";
import { cpSync } from "node:fs";

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
// Of the view of plots alone, which loads it when it is opened.
cpSync("node_modules/uplot/dist/uPlot.iife.min.js", `${out}/uplot.js`);
for (const file of ["index.html", "report.html", "icon.svg"]) cpSync(`src/${file}`, `${out}/${file}`);
