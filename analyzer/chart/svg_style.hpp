// The style sheet of every chart. Colours are those of Okabe and Ito (2008), which colour-blind people can
// tell apart. In black and white they differ in lightness. What matters differs in hatching or outline too.
// Lengths are tenths of a pixel.
#pragma once

namespace pal::analyzer::chart {

constexpr const char* style_sheet = R"svg(<style>
text { font-family: "DejaVu Sans", Verdana, sans-serif; font-size: 90px; fill: #000 }
.mid { text-anchor: middle } .end { text-anchor: end }
.title { font-size: 165px; font-weight: bold } .title.fails { fill: #a63c00 }
.subtitle { font-size: 115px } .strong { font-weight: bold }
.heading { font-size: 110px; font-weight: bold }
.name { font-size: 110px } .long { font-size: 78px } .device { font-style: italic } .processor { font-size: 110px; font-weight: bold } .processor.long { font-size: 90px }
.tick { font-size: 100px } .small, .number { font-size: 85px } .key { font-size: 90px } .key.number { font-weight: bold }
.on-dark { font-size: 85px; fill: #fff } .on-light { font-size: 85px }
.number.on-dark, .number.on-light { font-size: 85px }
.faded { fill: #666 }
.quiet { font-size: 85px; fill: #444; font-style: italic } .cut { font-size: 80px; fill: #444; font-style: italic }
.message-name, .halo { font-size: 85px; fill: #222; paint-order: stroke; stroke: #fff; stroke-width: 20px }
.figure { font-size: 105px; font-weight: bold } .figure.fails { fill: #a63c00 } .figure.holds { fill: #00563f }
.bar { stroke: #000; stroke-width: 5px }
.bar.computation { fill: #0072b2 } .bar.message { fill: #56b4e9 } .bar.conditional { fill: #f0e442 }
.bar.serving { fill: url(#serving) }
.bar.backdrop { fill: #fff; stroke: #666; stroke-width: 8px } .bar.unfinished { stroke-dasharray: 25 15 }
.ready { fill: url(#ready); stroke: #000; stroke-width: 5px } .ready.backdrop { fill: none; stroke: #888; stroke-dasharray: 20 20 }
.wait { stroke: #555; stroke-width: 12px; fill: none } .wait.backdrop { stroke: #aaa; stroke-dasharray: 30 20 }
.gave-up { stroke: #000; stroke-width: 16px; fill: none }
.arrow { stroke: #333; stroke-width: 8px; fill: none; marker-end: url(#head) }
.arrow.dropped { stroke-dasharray: 30 20; marker-end: none } .arrow.undelivered { stroke-dasharray: 10 20 }
.arrow.backdrop { stroke: #aaa; marker-end: none }
.wave { stroke: #000; stroke-width: 16px; fill: none } .wave.backdrop { stroke: #aaa; stroke-dasharray: 40 20 }
.set { fill: #000; stroke: #000; stroke-width: 8px } .read { fill: #fff; stroke: #000; stroke-width: 12px }
.set.backdrop { fill: #aaa; stroke: #aaa } .read.backdrop { stroke: #aaa }
.event { fill: #000 } .event.backdrop { fill: #fff; stroke: #888; stroke-width: 8px }
.loss { stroke: #d55e00; stroke-width: 25px; fill: none }
.overrun { stroke: #d55e00; stroke-width: 25px; fill: none } .cancelled { stroke: #000; stroke-width: 25px }
.broken { fill: #f6c8a8; stroke: #d55e00; stroke-width: 12px } .broken.backdrop { fill: #fff; stroke: #888 }
.ending { stroke: #000; stroke-width: 12px } .ending.fault { stroke: #d55e00 }
.guide { stroke: #e4e4e4; stroke-width: 5px } .grid { stroke: #d0d0d0; stroke-width: 5px; stroke-dasharray: 20 20 }
.axis { stroke: #000; stroke-width: 8px } .bracket { stroke: #000; stroke-width: 12px; fill: none }
.band.fails { fill: #d55e00; fill-opacity: 0.13 } .band.holds { fill: #009e73; fill-opacity: 0.11 }
.dimension { fill: none } .dimension.fails { stroke: #d55e00 } .dimension.holds { stroke: #009e73 }
.dimension.edge { stroke-width: 14px } .dimension.measure { stroke-width: 14px }
.dimension.measure.fails { marker-start: url(#fails-end); marker-end: url(#fails-end) }
.dimension.measure.holds { marker-start: url(#holds-end); marker-end: url(#holds-end) }
.dimension.backdrop { stroke-dasharray: 40 25 }
.compact .bar { stroke-width: 3px } .compact .arrow { stroke-width: 6px }
.segment { stroke: #000; stroke-width: 8px; fill: none }
.deadline { stroke: #000; stroke-width: 14px; stroke-dasharray: 50 25; fill: none } .deadline-flag { fill: #000 } .deadline-pointer { stroke: #000; stroke-width: 14px; fill: none }
.enlarged { fill: #000 } .fold, .paper { fill: #fff } .tear { stroke: #000; stroke-width: 8px; fill: none }
</style>
<defs>
<pattern id="ready" width="60" height="60" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="60" height="60" fill="#fff"/><rect width="25" height="60" fill="#e69f00"/></pattern>
<pattern id="serving" width="50" height="50" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)"><rect width="50" height="50" fill="#fff"/><rect width="10" height="50" fill="#777"/></pattern>
<marker id="head" markerUnits="userSpaceOnUse" markerWidth="70" markerHeight="60" refX="70" refY="30" orient="auto"><path d="M0 5L70 30L0 55Z" fill="#333"/></marker>
<marker id="fails-end" markerUnits="userSpaceOnUse" markerWidth="110" markerHeight="80" refX="110" refY="40" orient="auto-start-reverse"><path d="M0 0L110 40L0 80Z" fill="#d55e00"/></marker>
<marker id="holds-end" markerUnits="userSpaceOnUse" markerWidth="110" markerHeight="80" refX="110" refY="40" orient="auto-start-reverse"><path d="M0 0L110 40L0 80Z" fill="#009e73"/></marker>
</defs>
)svg";

}  // namespace pal::analyzer::chart
