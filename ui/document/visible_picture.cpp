// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/visible_picture.h"

#include "ui/document/visibility.h"
#include "ui/picture/section/section.h"

#include <algorithm>

namespace keyblock {

namespace {

class Hider {
public:
    Hider(const Checked& checked, const Visibility& visibility)
        : visibility_(visibility), scene_(*checked.scene), solved_(checked.cut ? checked.cut->scene : scene_) {
        for (std::size_t i = 0; i < scene_.joints.size(); ++i) sources_.push_back(isHidden("/joints", i));
        for (std::size_t i = 0; i < scene_.jointSets.size(); ++i) sources_.push_back(isHidden("/joint_sets", i));
    }

    void hide(SectionPicture& picture) const {
        if (visibility_.isHidden("/blocks")) picture.blocks.clear();
        std::erase_if(picture.blocks, [this](const BlockShape& shape) { return hidesBlock(shape.block); });
        std::erase_if(picture.bolts, [this](const BoltShape& shape) { return hidesBolt(shape.bolt); });
        if (std::ranges::find(sources_, true) == sources_.end()) return;
        for (BlockShape& shape : picture.blocks) shape.edgesHidden = hiddenEdges(shape);
    }

private:
    bool isHidden(const char* list, std::size_t index) const {
        return visibility_.isHidden(QString("%1/%2").arg(list).arg(index));
    }

    /// True if the block is given in the scene and hidden. Blocks that result from the cut have no object of their own.
    bool hidesBlock(int block) const {
        const std::size_t index = block;
        return block >= 0 && index < scene_.blocks.size() && isHidden("/blocks", index);
    }

    bool hidesBolt(int bolt) const {
        const std::size_t index = bolt;
        if (bolt < 0 || index >= solved_.bolts.size()) return false;
        if (visibility_.isHidden("/bolts")) return true;
        const int pattern = solved_.bolts[index].pattern;
        return pattern >= 0 ? isHidden("/bolt_patterns", static_cast<std::size_t>(pattern)) : isHidden("/bolts", index);
    }

    std::vector<char> hiddenEdges(const BlockShape& shape) const {
        const std::size_t index = shape.block;
        if (shape.block < 0 || index >= solved_.blocks.size()) return {};
        const Block& block = solved_.blocks[index];
        if (block.faces.size() != shape.outline.size()) return {};
        std::vector<char> hidden;
        for (const CutFace& face : block.faces) {
            const std::size_t source = face.source;
            hidden.push_back(face.source >= 0 && source < sources_.size() && sources_[source]);
        }
        return hidden;
    }

    const Visibility& visibility_;
    const Scene& scene_;
    const Scene& solved_;
    std::vector<bool> sources_;  // hidden joints, then joint sets, in the numbering of faces
};

}  // namespace

std::shared_ptr<const SectionPicture> visiblePicture(const Checked& checked, const Visibility& visibility) {
    if (!checked.picture || visibility.showsAll()) return checked.picture;
    auto picture = std::make_shared<SectionPicture>(*checked.picture);
    Hider(checked, visibility).hide(*picture);
    return picture;
}

}  // namespace keyblock
