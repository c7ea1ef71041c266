#include "app/report/report_style.h"

#include "widgets/theme/theme.h"

#include <fmt/format.h>

namespace halbench::app {
namespace {

std::string roleVariables(const widgets::Theme& theme) {
    const auto variable = [](const char* name, const QColor& colour) {
        return fmt::format("--{}:{};", name, colour.name().toStdString());
    };
    return ":root{" + variable("window", theme.window) + variable("panel", theme.panel) +
           variable("raised", theme.raised) + variable("text", theme.text) + variable("muted", theme.muted) +
           variable("line", theme.line) + variable("accent", theme.accent) + variable("good", theme.good) +
           variable("warn", theme.warn) + variable("bad", theme.bad) +
           variable("simulated", theme.simulated) + "}\n";
}

constexpr const char* Rules = R"(*{box-sizing:border-box}
body{margin:0;background:var(--window);color:var(--text);font:14px/1.5 "DejaVu Sans","Segoe UI",Helvetica,Arial,sans-serif}
main{max-width:928px;margin:0 auto;padding:24px}
header,section{background:var(--panel);border:1px solid var(--line);padding:16px 23px;margin-bottom:12px}
h1{font-size:22px;line-height:1.3;margin:0 0 8px}
h2{font-size:16px;line-height:1.4;margin:0 0 8px}
p{margin:8px 0;max-width:100ch;overflow-wrap:break-word}
.badges:empty{display:none}
.badge{display:inline-block;border:1px solid currentColor;padding:1px 8px;margin-right:8px;font-weight:bold;font-size:13px}
.good{color:var(--good)} .warn{color:var(--warn)} .bad{color:var(--bad)} .muted{color:var(--muted)}
.simulated{color:var(--simulated)}
nav{padding:0 0 12px;line-height:1.9}
nav a{color:var(--accent);text-decoration:none;margin-right:20px;white-space:nowrap}
nav a:hover,nav a:focus{text-decoration:underline}
dl{display:grid;grid-template-columns:repeat(auto-fill,minmax(380px,1fr));gap:0 24px;margin:8px 0}
dl div{display:flex;border-bottom:1px solid var(--line);padding:3px 0}
dt{flex:0 0 216px;color:var(--muted)}
dd{flex:1;min-width:0;margin:0;overflow-wrap:anywhere;font-variant-numeric:tabular-nums}
.table{overflow-x:auto;margin:12px 0}
table{border-collapse:collapse;min-width:50%;font-variant-numeric:tabular-nums}
caption{text-align:left;font-weight:bold;padding:0 0 4px}
th,td{text-align:left;vertical-align:top;padding:4px 16px 4px 0;border-bottom:1px solid var(--line)}
th{color:var(--muted);font-weight:normal}
th.number,td.number{text-align:right;white-space:nowrap}
td.good,td.bad,td.warn{font-weight:bold}
.quality{border-left:4px solid var(--line);background:var(--window);padding:4px 16px;margin:12px 0}
.quality p{margin:4px 0} .quality ul{margin:4px 0;padding-left:20px}
.good-edge{border-left-color:var(--good)} .warn-edge{border-left-color:var(--warn)} .bad-edge{border-left-color:var(--bad)}
figure{margin:16px 0}
figure svg{display:block;max-width:100%;height:auto}
figcaption{color:var(--muted);font-size:13px;margin-top:4px;max-width:100ch}
@media print{body{background:none}main{max-width:none;padding:0}nav{display:none}
header,section{border:0;padding:0}figure,tr,.quality{break-inside:avoid}h2{break-after:avoid}}
)";

} // namespace

std::string reportStyle(const widgets::Theme& theme) {
    return roleVariables(theme) + Rules;
}

} // namespace halbench::app
