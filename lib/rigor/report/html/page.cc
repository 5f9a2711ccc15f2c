// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/html/page.h>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>

namespace rigor::report {
namespace {

constexpr std::string_view kPageStyle = R"(
:root{color-scheme:light dark;--ink:#1c2430;--back:#fff;--soft:#6b7683;--line:#d9dfe6;--pass:#18794e;
--warn:#ad5700;--fail:#ce2c31;--c0:#0b68cb;--c1:#c2410c;--c2:#18794e;--c3:#8e4ec6;--c4:#ad5700;--c5:#0e7490}
@media(prefers-color-scheme:dark){:root{--ink:#e6e9ee;--back:#12161c;--soft:#98a2ae;--line:#2b333d;
--pass:#3dd68c;--warn:#ffb224;--fail:#ff6369;--c0:#52a9ff;--c1:#ff8b3e;--c2:#3dd68c;--c3:#bf7af0;
--c4:#ffb224;--c5:#4ccce6}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--back);margin:2rem auto;
max-width:76rem;padding:0 1rem}h1{font-size:1.4rem}h2{font-size:1.15rem;margin-top:2.5rem}
table{border-collapse:collapse;margin:.5rem 0}td,th{padding:.15rem .7rem .15rem 0;text-align:left;
border-bottom:1px solid var(--line)}td.n{text-align:right;font-variant-numeric:tabular-nums}
pre{white-space:pre-wrap;background:color-mix(in srgb,var(--line) 40%,transparent);padding:.7rem}
.pass{color:var(--pass)}.warn,.solver{color:var(--warn)}.fail,.invalid{color:var(--fail)}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(22rem,1fr));gap:.5rem}
svg{width:100%}svg path{fill:none;stroke-width:1.4}svg text{font:10px system-ui,sans-serif;
fill:var(--soft)}svg .title{font-size:12px;fill:var(--ink)}svg .mid{text-anchor:middle}
svg .end{text-anchor:end}svg .grid{stroke:var(--line);stroke-width:.7}.dot{fill:var(--c0)}
.s0{stroke:var(--c0)}.s1{stroke:var(--c1)}.s2{stroke:var(--c2)}.s3{stroke:var(--c3)}
.s4{stroke:var(--c4)}.s5{stroke:var(--c5)}
)";

std::string security_policy(const PageHead& head) {
  std::string policy = "default-src 'none'; style-src 'unsafe-inline'";
  if (!head.images.empty()) policy += fmt::format("; img-src {}", head.images);
  if (!head.script_hash.empty()) policy += fmt::format("; script-src '{}'", head.script_hash);
  return policy + "; base-uri 'none'; form-action 'none'";
}

}  // namespace

std::string begin_page(const PageHead& head) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width\"/>\n"
      "<title>{}</title>\n<style>{}{}</style></head><body>\n",
      security_policy(head), escaped(head.title), kPageStyle, head.style);
}

std::string end_page() { return "</body></html>\n"; }

}  // namespace rigor::report
