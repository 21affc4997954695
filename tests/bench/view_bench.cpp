// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a frame of a run costs on the screen: blocks that move a little and change
// their colours, 1600 × 1000 pixels. Takes a display (`xvfb-run` gives one).
#include "ui/picture/section/section.h"
#include "ui/view/section_view.h"

#include <benchmark/benchmark.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath>
#include <cstdlib>

namespace keyblock {
namespace {

/// About `count` four-sided blocks with as many colours, moved by the frame's number.
SectionPicture wall(int count, int frame) {
    SectionPicture picture;
    const int columns = static_cast<int>(std::lround(std::sqrt(1.6 * count)));
    LegendBar legend;
    legend.map = &slate;
    legend.range = {0.0, 1.0};
    picture.blockLegend = legend;
    for (int i = 0; i < count; ++i) {
        const Point at(i % columns, i / columns), skew(0.3, 1.0);
        BlockShape block;
        block.block = i;
        block.before = {at, at + Point(1.0, 0.1), at + Point(1.0, 0.1) + skew, at + skew};
        block.outline = block.before;
        for (Point& corner : block.outline) corner.y() += 0.002 * (frame % 100);
        block.value = 0.5 + 0.5 * std::sin(0.01 * i + 0.1 * frame);
        picture.blocks.push_back(std::move(block));
    }
    picture.model = {{0.0, 0.0}, {columns + 1.3, count / columns + 2.1}};
    return picture;
}

void frames(benchmark::State& state) {
    if (!std::getenv("DISPLAY")) return state.SkipWithError("there is no display");
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(1600, 1000);
    window->AddRenderer(renderer);
    SectionView view(*renderer);
    const int count = static_cast<int>(state.range(0));
    std::vector<SectionPicture> pictures;
    for (int i = 0; i < 8; ++i) pictures.push_back(wall(count, i));
    const Box model = pictures[0].model;
    ViewColours colours;
    colours.opening = colours.ground = rgb(0xF7F7F5);
    std::size_t next = 0;
    for (auto _ : state) {
        const SectionPicture& picture = pictures[next++ % pictures.size()];
        view.show(picture, colours, {});
        view.look(0.5 * (model.min + model.max), (model.max.x() - model.min.x()) / 1600.0, Point(1600.0, 1000.0),
                  &picture);
        window->Render();
        window->WaitForCompletion();
    }
    state.counters["joinings"] = view.joinings();
}
BENCHMARK(frames)->Arg(300)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace keyblock
