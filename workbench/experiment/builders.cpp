#include "experiment/builders.h"

#include "coppice/base/named.h"
#include "coppice/builders/method.h"
#include "coppice/sample/sampler.h"

#include "tracers/contestant.h"

#include <algorithm>
#include <span>

namespace coppice::lab {

namespace {

/// Of the samplers asked for, or that of a builder's own.
std::vector<std::string> samplers_or(const ExperimentOptions& options, const std::string& own) {
    return options.samplers.empty() ? std::vector{own} : options.samplers;
}

Builder protocol_builder(const ExperimentOptions& options, const std::string& name) {
    const Protocol& protocol = find_protocol(name);
    const std::string usual(sampler_registry().front().name);
    return {protocol.name, protocol.summary, TreeForm::kd, true, samplers_or(options, usual),
            &protocol};
}

Builder method_builder(const ExperimentOptions& options, const std::string& name) {
    const std::vector<MethodEntry> entries = experiment_methods();
    const MethodEntry& entry = find_named(std::span<const MethodEntry>(entries), name, "method");
    const auto peers = peer_registry();
    const bool is_peer = std::any_of(peers.begin(), peers.end(),
                                     [&](const Peer& peer) { return peer.name == name; });
    if (is_peer) return {entry.name, entry.summary, TreeForm::peer, false, {""}, nullptr};
    const Method& method = find_method(name);
    const bool is_sampling = method.uses_sample();
    const TreeForm form = method.tree() == TreeKind::bvh8 ? TreeForm::bvh8 : TreeForm::kd;
    return {entry.name,
            entry.summary,
            form,
            is_sampling,
            is_sampling ? samplers_or(options, sample_of(method.options()).sampler)
                        : std::vector<std::string>{""},
            nullptr};
}

}  // namespace

std::vector<MethodEntry> experiment_methods() {
    std::vector<MethodEntry> entries;
    for (const Method& method : method_registry()) {
        // An automatic one is one of the others.
        if (!method.is_automatic()) entries.push_back({method.name, method.summary});
    }
    for (const Peer& peer : peer_registry()) {
        entries.push_back({peer.name, peer.summary});
    }
    return entries;
}

std::vector<Builder> builders_of(const ExperimentOptions& options) {
    std::vector<Builder> builders;
    for (const std::string& name : options.protocols) {
        builders.push_back(protocol_builder(options, name));
    }
    for (const std::string& name : options.methods) {
        builders.push_back(method_builder(options, name));
    }
    return builders;
}

std::string_view builder_summary(std::string_view builder) {
    for (const Protocol& protocol : protocol_registry()) {
        if (protocol.name == builder) return protocol.summary;
    }
    const std::vector<MethodEntry> entries = experiment_methods();
    return find_named(std::span<const MethodEntry>(entries), builder, "method").summary;
}

BuildOptions options_of(const Builder& builder, const KdOptions& base, const std::string& sampler,
                        double percent, std::uint64_t seed) {
    if (builder.protocol != nullptr) {
        KdOptions options = base;
        options.sample.sampler = sampler;
        return builder.protocol->options(options, percent / 100.0, seed);
    }
    if (builder.form == TreeForm::peer) return base;
    BuildOptions options = find_method(builder.name).options();
    cost_of(options).traversal = base.cost.traversal;
    cost_of(options).intersection = base.cost.intersection;
    set_threads(options, base.threads);
    SampleOptions& sample = sample_of(options);
    sample.seed = seed;
    if (builder.is_sampling) {
        sample.rate = percent / 100.0;
        sample.sampler = sampler;
    }
    return options;
}

}  // namespace coppice::lab
