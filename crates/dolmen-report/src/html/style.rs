//! Style of the page: inline, for screens and A4.

/// The whole style sheet.
pub(super) const STYLE: &str = "
:root{--text:#1f2328;--grey:#5d646b;--line:#d5d9dd;--paper:#fff;--tint:#f6f5f2;--good:#009e73;--warn:#b57900;--bad:#c04a00;--unknown:#5d646b}
*{box-sizing:border-box}
html{font-size:15px;-webkit-text-size-adjust:100%}
body{margin:0 auto;padding:2.2rem 1.6rem 4rem;max-width:53rem;background:var(--paper);color:var(--text);
 font-family:'Noto Sans CJK KR','Noto Sans KR','Malgun Gothic','Apple SD Gothic Neo','Helvetica Neue',Arial,sans-serif;line-height:1.6;word-break:keep-all;overflow-wrap:break-word}
h1{font-size:1.75rem;line-height:1.25;margin:0 0 .2rem}
h2{font-size:1.22rem;margin:2.4rem 0 .7rem;padding-bottom:.25rem;border-bottom:2px solid var(--text)}
h3{font-size:1.02rem;margin:1.5rem 0 .4rem}
p{margin:.55rem 0}
.sub{color:var(--grey);margin:0 0 .25rem}
.kicker{color:var(--grey);font-size:.85rem;letter-spacing:.03em;margin:0 0 .3rem}
.verdict{display:flex;gap:1.1rem;align-items:center;margin:1.2rem 0;padding:.9rem 1.1rem;border:1px solid var(--line);border-left:.55rem solid var(--unknown);background:var(--tint)}
.verdict .word{font-size:1.55rem;font-weight:700;white-space:nowrap}
.verdict.stable{border-left-color:var(--good)}.verdict.stable .word{color:#00734f}
.verdict.marginal{border-left-color:#e69f00}.verdict.marginal .word{color:#8a5c00}
.verdict.unstable{border-left-color:#d55e00}.verdict.unstable .word{color:#a83f00}
.verdict p{margin:.1rem 0}
.verdict .scale{color:var(--grey);font-size:.85rem}
ul.findings{list-style:none;margin:.6rem 0;padding:0}
ul.findings li{position:relative;padding:.28rem 0 .28rem 1.7rem}
ul.findings li::before{position:absolute;left:.15rem;font-weight:700}
li.good::before{content:'●';color:var(--good)}
li.warn::before{content:'◆';color:#e69f00}
li.bad::before{content:'✕';color:#d55e00}
li.plain::before{content:'–';color:var(--grey)}
li.unknown::before{content:'?';color:var(--unknown)}
.wrong{border:1px solid var(--line);border-left:.55rem solid #d55e00;padding:.55rem 1rem;margin:1rem 0;background:#fdf4ee}
.note{border-left:.3rem solid var(--line);padding:.1rem .9rem;margin:.8rem 0;color:var(--grey)}
math{font-size:1.1rem;margin:.9rem 0 .4rem}.equation{break-inside:avoid}.equation .note{border:0;padding:0;margin:.2rem 0 1rem}
figure{margin:1.1rem 0;break-inside:avoid}
figure svg{display:block;max-width:100%;height:auto;margin:0 auto}
figcaption,caption{font-size:.87rem;color:var(--grey);text-align:left;line-height:1.45}
figure img{display:block;max-width:100%;max-height:30rem;margin:0 auto}
figcaption{margin-top:.35rem}
figcaption b,caption b,caption .no,figcaption .no{color:var(--text)}
caption .no,figcaption .no{font-weight:600;margin-right:.4em}h1 .no,h2 .no,h3 .no{margin-right:.35em}
.pair{display:flex;flex-wrap:wrap;gap:.6rem 1rem;justify-content:center}
.pair figure{flex:1 1 20rem;margin:.6rem 0}
dl.cover{display:grid;grid-template-columns:max-content 1fr;gap:.15rem 1rem;margin:.7rem 0;font-size:.93rem}
dl.cover dt{color:var(--grey)}dl.cover dd{margin:0}
.answers{display:grid;grid-template-columns:repeat(auto-fit,minmax(13rem,1fr));gap:.7rem;margin:1rem 0;break-inside:avoid}
.answers div{border-left:.3rem solid var(--unknown);background:var(--tint);padding:.5rem .8rem}
.answers p{margin:.1rem 0}.answers .question{color:var(--grey);font-size:.85rem}.answers .word{font-weight:700}
.answers .good{border-left-color:var(--good)}.answers .good .word{color:#00734f}
.answers .warn{border-left-color:#e69f00}.answers .warn .word{color:#8a5c00}
.answers .bad{border-left-color:#d55e00}.answers .bad .word{color:#a83f00}
table.signatures td{height:3rem;vertical-align:middle;white-space:normal}table.signatures th:last-child{width:28%}
.scroll{overflow-x:auto;margin:.9rem 0}
.short{break-inside:avoid}
table{border-collapse:collapse;width:100%;font-size:.87rem;font-variant-numeric:tabular-nums;line-height:1.4}
caption{caption-side:top;padding-bottom:.35rem}
th,td{padding:.27rem .55rem;text-align:right;border-bottom:1px solid var(--line);vertical-align:top}
thead th{border-bottom:1.5px solid var(--text);vertical-align:bottom;font-weight:600}
tbody tr:last-child td{border-bottom:1.5px solid var(--text)}
td{white-space:nowrap}.t{text-align:left}td.t:first-child,td.wrap{white-space:normal}td.t:first-child{min-width:4.5em}td.wrap{min-width:9em}
sub{font-size:.75em;line-height:0}
td.assumed{background:#fff3d6}
.bad-number{color:#a83f00;font-weight:600}
code{font-family:ui-monospace,'D2Coding',Consolas,Menlo,monospace;font-size:.88em}
nav ol{padding-left:1.4rem}
a{color:#0060a0}
footer{margin-top:2.6rem;padding-top:.6rem;border-top:1px solid var(--line);color:var(--grey);font-size:.85rem}
nav+article{margin-top:2.2rem;border-top:4px solid var(--text);padding-top:1.6rem}
article+article{margin-top:4rem;border-top:4px solid var(--text);padding-top:2rem}
@page{size:A4;margin:16mm 15mm 18mm}
@media print{
 html{font-size:10.2pt}
 body{max-width:none;padding:0}
 h1,h2,h3{break-after:avoid}
 tr,.verdict,.wrong,li{break-inside:avoid}
 thead{display:table-header-group}
 .scroll{overflow:visible}
 article+article{break-before:page;border-top:0;margin-top:0;padding-top:0}
 *{-webkit-print-color-adjust:exact;print-color-adjust:exact}
 a{color:inherit;text-decoration:none}
}
";
