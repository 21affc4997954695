// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A type based on another one is read over a copy of it, so the other type is read
// first. Sources of values that are redefined are not copied.
#include "solver/files/scene/bolt_type_reader.h"

#include "solver/files/json/field_json.h"
#include "solver/files/json/object_reader.h"
#include "solver/scene/field.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <unordered_map>

namespace keyblock {

namespace {

const BoltType* findType(const std::vector<BoltType>& types, std::string_view name) {
    const auto found =
        std::find_if(types.begin(), types.end(), [&](const BoltType& type) { return type.name == name; });
    return found == types.end() ? nullptr : &*found;
}

constexpr int longestChain = 32;  // maximum number of types based on one another in a chain

class BoltTypeReader {
public:
    BoltTypeReader(const JsonObject& members, const std::vector<BoltType>& library, const std::string& pointer,
                   std::vector<Problem>& problems)
        : members_(members), library_(library), pointer_(pointer), problems_(problems),
          states_(members.size(), State::Unread), types_(members.size()) {
        for (std::size_t i = 0; i < members.size(); ++i)
            indices_.emplace(members[i].key, i);
    }

    std::vector<BoltType> read() {
        for (std::size_t i = 0; i < members_.size(); ++i)
            readType(i);
        return std::move(types_);
    }

private:
    enum class State { Unread, Reading, Read };

    void readType(std::size_t index) {
        if (states_[index] != State::Unread)
            return;
        states_[index] = State::Reading;
        const JsonMember& member = members_[index];
        const BoltType base = baseOf(member);
        BoltType type = base;
        type.name = member.key;
        type.builtIn = false;
        type.like.clear();
        type.sources.clear();
        readObject(member.node, boltTypeStructure(), &type, under(pointer_, member.key), problems_);
        inheritSources(base, type);
        types_[index] = std::move(type);
        states_[index] = State::Read;
    }

    // Initial values of a type: a copy of the type on which it is based, or the defaults.
    BoltType baseOf(const JsonMember& member) {
        const JsonNode* like = findMember(member.node, "like");
        const auto* name = like ? std::get_if<std::string>(&like->value) : nullptr;
        if (!name || name->empty())
            return {};
        if (const auto own = indices_.find(*name); own != indices_.end())
            return ownBase(own->second, *like, member);
        if (const BoltType* type = findType(library_, *name))
            return *type;
        addError(problems_, *like, under(under(pointer_, member.key), "like"),
                 "there is no bolt type " + inQuotes(*name), suggestion(*name, allNames()));
        return usable();
    }

    BoltType ownBase(std::size_t index, const JsonNode& like, const JsonMember& member) {
        if (states_[index] == State::Reading) {
            addError(problems_, like, under(under(pointer_, member.key), "like"),
                     inQuotes(member.key) + " is based on " + inQuotes(members_[index].key) +
                         ", which is based on it in turn",
                     "Define one of them without 'like', or base it on a built-in type");
            return usable();
        }
        if (depth_ > longestChain) {
            addError(problems_, like, under(under(pointer_, member.key), "like"),
                     "more than " + std::to_string(longestChain) + " types are based on one another in a chain",
                     "Define one of them without 'like'");
            return usable();
        }
        ++depth_;
        readType(index);
        --depth_;
        return types_[index];
    }

    // A type with steel properties, so that a wrong `like` is not also reported as missing steel.
    static BoltType usable() {
        BoltType type;
        type.youngsModulus = 200e9;
        return type;
    }

    // A key of `sources` is that of a field or of part of a field, such as `plate.normal_strength`.
    static void inheritSources(const BoltType& base, BoltType& type) {
        for (const auto& [key, source] : base.sources) {
            const Field* field = findField(boltTypeStructure(), key.substr(0, key.find('.')));
            if (field && sameValue(*field, &type, &base))
                type.sources.emplace(key, source);
        }
    }

    std::vector<std::string_view> allNames() const {
        std::vector<std::string_view> names;
        for (const JsonMember& member : members_)
            names.push_back(member.key);
        for (const BoltType& type : library_)
            names.push_back(type.name);
        return names;
    }

    const JsonObject& members_;
    const std::vector<BoltType>& library_;
    const std::string& pointer_;
    std::vector<Problem>& problems_;
    std::vector<State> states_;
    std::vector<BoltType> types_;
    std::unordered_map<std::string_view, std::size_t> indices_;
    int depth_ = 0;
};

}  // namespace

std::vector<BoltType> readBoltTypes(const JsonNode& node, const std::vector<BoltType>& library,
                                    const std::string& pointer, std::vector<Problem>& problems) {
    if (const auto* members = std::get_if<JsonObject>(&node.value))
        return BoltTypeReader(*members, library, pointer, problems).read();
    addError(problems, node, pointer,
             "'bolt_types' is " + std::string(kindText(node)) + ", but must be an object with named members",
             "Write { \"name\": { … } }");
    return {};
}

}  // namespace keyblock
