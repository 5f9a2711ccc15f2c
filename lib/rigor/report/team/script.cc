// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/team/script.h>

namespace rigor::report {
namespace {

constexpr std::string_view kReportStyle = R"(
body{max-width:84rem}h2{margin-top:2rem}h3{font-size:1rem;margin:1.4rem 0 .4rem}
a{color:var(--c0)}small,.soft{color:var(--soft);font-weight:normal}
.tiles{display:flex;flex-wrap:wrap;gap:.5rem;padding:0;margin:.5rem 0;list-style:none}
.tiles li{border:1px solid var(--line);border-radius:.4rem;padding:.3rem .7rem}
.tiles b{font-size:1.2rem;font-variant-numeric:tabular-nums}.tiles .none{color:var(--soft)}
.tiles .pass b{color:var(--pass)}.tiles .warning b,.tiles .warn b,.tiles .solver b{color:var(--warn)}
.tiles .error b,.tiles .fail b,.tiles .invalid b{color:var(--fail)}
#tools{display:flex;flex-wrap:wrap;gap:1rem;align-items:center;margin:1rem 0 .5rem}
#tools[hidden]{display:none}input,select{font:inherit;color:inherit;background:var(--back);
border:1px solid var(--soft);border-radius:.3rem;padding:.15rem .4rem}
.wide{overflow-x:auto}#models{width:100%}#models td,#models th{padding:.35rem .9rem .35rem 0;
vertical-align:middle}#models thead th{position:sticky;top:0;background:var(--back);vertical-align:bottom;
font-size:.85rem;line-height:1.2}#models tr[hidden]{display:none}
#models tbody tr:hover{background:color-mix(in srgb,var(--line) 35%,transparent)}
#models td{white-space:nowrap}#models small{display:block;overflow-wrap:anywhere}#models th[scope]{min-width:14rem}
th.n{text-align:right}td.error{color:var(--fail);font-weight:bold}td.warning{color:var(--warn);font-weight:bold}
th button{font:inherit;font-weight:bold;color:inherit;background:none;border:0;padding:0;cursor:pointer;
text-align:inherit}th button:hover{text-decoration:underline}th[aria-sort=ascending] button::after{content:" ▲"}
th[aria-sort=descending] button::after{content:" ▼"}
.over{color:var(--fail);font-size:.8rem;white-space:nowrap}
td.thumbnail{padding-right:.6rem}.thumbnail img{display:block;width:6rem;height:4.5rem}
img{border-radius:.3rem;background:#f2f5f7;color:#1c2430;font-size:.75rem}
.model{border-top:2px solid var(--line);margin-top:1rem;content-visibility:auto;
contain-intrinsic-size:auto 16rem}.model h2{font-size:1.1rem;margin:.5rem 0;overflow-wrap:anywhere}.model h2 small{display:block;font-size:.85rem}
.facts{display:flex;flex-wrap:wrap;gap:1rem;align-items:flex-start}.facts img{max-width:100%;height:auto}.facts>img{width:14rem}.facts div{min-width:0}
.facts>div{flex:1 1 18rem}.facts table{font-size:.85rem}.causes{padding-left:1.2rem;margin:.3rem 0;line-height:1.3;font-size:.9rem}
.findings{list-style:none;padding:0;margin:0}.finding{border-left:.25rem solid var(--soft);padding-left:.8rem;
margin:.8rem 0}.finding.error{border-color:var(--fail)}.finding.warning{border-color:var(--warn)}
.finding p{margin:0;overflow-wrap:anywhere}.finding pre{margin:.3rem 0 0;padding:.4rem .7rem;font-size:.8rem;line-height:1.35;
white-space:pre;overflow-x:auto}.finding .note{font-size:.85rem;margin:.2rem 0 0 .7rem;color:var(--soft)}.badge{font-weight:bold}.error .badge{color:var(--fail)}
.warning .badge{color:var(--warn)}summary{cursor:pointer}details{margin:.5rem 0}
:target{scroll-margin-top:3rem}
@media(max-width:40rem){body{margin:1rem auto}.plots{grid-template-columns:1fr}}
@media print{body{max-width:none;margin:0}#tools{display:none}.model{content-visibility:visible}
#models thead th{position:static}.finding,.facts,svg,tr{break-inside:avoid}
details::details-content{content-visibility:visible;height:auto}a{color:inherit}}
)";

constexpr std::string_view kScript = R"('use strict';
(function () {
  const table = document.getElementById('models');
  if (!table) return;
  const body = table.tBodies[0];
  const rows = Array.from(body.rows);
  const text = document.getElementById('filter');
  const only = document.getElementById('only');
  const shown = document.getElementById('shown');
  function filter() {
    const word = text.value.toLowerCase();
    let count = 0;
    for (const row of rows) {
      const named = row.cells[1].textContent.toLowerCase().includes(word);
      const marked = only.value === 'all' || row.dataset.is.split(' ').includes(only.value);
      row.hidden = !named || !marked;
      if (!row.hidden) count += 1;
    }
    shown.textContent = count + ' of ' + rows.length;
  }
  function key(row, column) {
    const cell = row.cells[column];
    return cell.dataset.v === undefined ? cell.textContent.toLowerCase() : Number(cell.dataset.v);
  }
  function sort(head, column) {
    const down = head.getAttribute('aria-sort') === 'ascending' ? -1 : 1;
    for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
    head.setAttribute('aria-sort', down === 1 ? 'ascending' : 'descending');
    const keyed = rows.map(function (row, place) { return [key(row, column), place, row]; });
    keyed.sort(function (a, b) {
      if (a[0] === b[0]) return a[1] - b[1];
      return a[0] > b[0] ? down : -down;
    });
    body.append(...keyed.map(function (entry) { return entry[2]; }));
  }
  Array.from(table.tHead.rows[0].cells).forEach(function (head, column) {
    if (column === 0) return;
    const button = document.createElement('button');
    button.textContent = head.textContent;
    button.addEventListener('click', function () { sort(head, column); });
    head.replaceChildren(button);
  });
  text.addEventListener('input', filter);
  only.addEventListener('change', filter);
  document.getElementById('tools').hidden = false;
  filter();
})();
)";

}  // namespace

std::string_view team_report_style() { return kReportStyle; }
std::string_view team_report_script() { return kScript; }

/// Of the bytes above: `sha256sum | xxd -r -p | base64`; a test holds them together.
std::string_view team_report_script_hash() {
  return "sha256-cQyZNJKfZ9dsqjLwOzED0aYW9YOXOReL7BuStdkJn1A=";
}

}  // namespace rigor::report
