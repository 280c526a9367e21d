#include "io/report_page.h"

namespace tidewater::io {

const char* const report_style =
    R"(:root { --ink: #262a30; --soft: #5b6470; --line: #d5dae0; --sea: #1f6f9f; --wash: #f3f6f8; }
* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: var(--ink); font: 16px/1.5 "DejaVu Sans", Arial, sans-serif; }
main, header { margin: 0 auto; max-width: 1160px; padding: 0 20px; }
header { padding-top: 28px; border-bottom: 3px solid var(--sea); }
h1 { margin: 0 0 6px; font-size: 1.8rem; line-height: 1.25; }
h2 { margin: 40px 0 12px; font-size: 1.3rem; }
h3 { margin: 24px 0 4px; font-size: 1.05rem; }
p { margin: 6px 0; }
.soft, figcaption, caption { color: var(--soft); font-size: 0.9rem; }
nav { margin: 10px 0; display: flex; flex-wrap: wrap; gap: 6px 18px; }
a { color: var(--sea); }
#warnings ul { margin: 0; padding: 10px 16px 10px 34px; border-left: 5px solid #b65c00; background: #fdf3e7; }
#warnings .fine { padding: 10px 16px; border-left: 5px solid #2c7a4b; background: #edf6f0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding: 4px 0; }
th, td { padding: 5px 10px; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { background: var(--wash); white-space: nowrap; }
td.number { text-align: right; white-space: nowrap; }
th button { all: unset; cursor: pointer; font-weight: bold; }
th button:focus-visible { outline: 2px solid var(--sea); }
th[aria-sort="ascending"] button::after { content: " \25b2"; }
th[aria-sort="descending"] button::after { content: " \25bc"; }
.within { color: #20663c; font-weight: bold; white-space: nowrap; }
.outside { color: #9c4a00; font-weight: bold; white-space: nowrap; }
figure { margin: 0; min-width: 0; }
figure img { width: 100%; height: auto; border: 1px solid var(--line); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 500px), 1fr)); gap: 26px; align-items: start; }
@media (max-width: 600px) {
  body { font-size: 15px; }
  main, header { padding-left: 12px; padding-right: 12px; }
}
@media print { nav, #controls { display: none; } figure, tr { break-inside: avoid; } }
)";

const char* const report_script = R"(<script>
function value(row, column) {
  const text = row.cells[column].textContent.trim(), number = Number(text);
  return text !== "" && !Number.isNaN(number) ? number : text;
}
function compare(a, b) {
  if (typeof a === typeof b) return a < b ? -1 : a > b ? 1 : 0;
  return typeof a === "number" ? -1 : 1;
}
document.querySelectorAll("table.sortable").forEach((table) => {
  const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0];
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = head.textContent;
    head.replaceChildren(button);
    button.addEventListener("click", () => {
      const up = head.getAttribute("aria-sort") !== "ascending";
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", up ? "ascending" : "descending");
      const rows = [...body.rows].sort((a, b) => compare(value(a, column), value(b, column)) * (up ? 1 : -1));
      body.append(...rows);
    });
  });
});
</script>
)";

}  // namespace tidewater::io
