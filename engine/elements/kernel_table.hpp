#pragma once

#include <algorithm>

#include "elements/frequency.hpp"
#include "elements/kernels.hpp"
#include "elements/quad_mean_dilatation.hpp"
#include "elements/quad_one_point.hpp"
#include "elements/triangle.hpp"

/// Instantiates every combination of element, geometry and effects for one instruction set.
namespace percuss::PERCUSS_ISA {

template <class Element, class Real>
void run_forces(Batch& batch, const Node* nodes, double dt, int begin, int end, KernelSums& sums) {
    for (int block = begin; block < end; ++block) {
        const int filled = batch.filled(block);
        if (filled == block_lanes) {
            for (int lane = 0; lane < block_lanes; lane += lanes_of<Real>)
                Element::template update<Real>(batch, nodes, dt, block, lane, sums);
        } else {
            for (int lane = 0; lane < filled; ++lane)
                Element::template update<double>(batch, nodes, dt, block, lane, sums);
        }
    }
}

template <class Frequency, class Real>
double run_frequency(const Batch& batch, const Node* nodes, int begin, int end) {
    double highest = 0;
    for (int block = begin; block < end; ++block) {
        const int filled = batch.filled(block);
        if (filled == block_lanes) {
            for (int lane = 0; lane < block_lanes; lane += lanes_of<Real>) {
                double values[lanes_of<Real>];
                store(values, Frequency::template bound<Real>(batch, nodes, block, lane));
                for (const double value : values) highest = std::max(highest, value);
            }
        } else {
            for (int lane = 0; lane < filled; ++lane)
                highest = std::max(highest, Frequency::template bound<double>(batch, nodes, block, lane));
        }
    }
    return highest;
}

template <class Volume, class Real>
void run_volumes(Batch& batch, const Node* nodes, int begin, int end) {
    for (int block = begin; block < end; ++block) {
        const int filled = batch.filled(block);
        if (filled == block_lanes) {
            for (int lane = 0; lane < block_lanes; lane += lanes_of<Real>)
                Volume::template update<Real>(batch, nodes, block, lane);
        } else {
            for (int lane = 0; lane < filled; ++lane)
                Volume::template update<double>(batch, nodes, block, lane);
        }
    }
}

template <class Element, class Frequency, class Real>
KernelSet kernel_set() {
    return {&run_forces<Element, Real>, &run_frequency<Frequency, Real>, Element::state_size,
            Element::points,            Element::law_begin,              (Element::state_size - Element::law_begin) / Element::points};
}

template <class Law, class Real, Geometry geometry, bool viscous, bool averaged>
KernelSet triangle_set() {
    KernelSet set = kernel_set<Triangle<Law, geometry, viscous, averaged>,
                               TriangleFrequency<geometry, viscous, averaged>, Real>();
    if constexpr (averaged) {
        set.volumes = &run_volumes<TriangleVolume<geometry, viscous>, Real>;
        set.volume_components = TriangleVolume<geometry, viscous>::components;
    }
    return set;
}

template <class Law, class Real, Geometry geometry, bool viscous>
KernelSet kernel_of_kind(const KernelChoice& choice) {
    if (choice.kind == ElementKind::quad_mean_dilatation)
        return kernel_set<QuadMeanDilatation<Law, geometry, viscous>, QuadMeanDilatationFrequency<geometry, viscous>,
                          Real>();
    if (choice.kind == ElementKind::triangle) return triangle_set<Law, Real, geometry, viscous, false>();
    if (choice.kind == ElementKind::triangle_averaged)
        return triangle_set<Law, Real, geometry, viscous, true>();
    if (choice.hourglass)
        return kernel_set<QuadOnePoint<Law, geometry, true, viscous>, QuadOnePointFrequency<geometry, true, viscous>,
                          Real>();
    return kernel_set<QuadOnePoint<Law, geometry, false, viscous>, QuadOnePointFrequency<geometry, false, viscous>,
                      Real>();
}

template <class Law, class Real, Geometry geometry>
KernelSet kernel_of_effects(const KernelChoice& choice) {
    return choice.viscous ? kernel_of_kind<Law, Real, geometry, true>(choice)
                          : kernel_of_kind<Law, Real, geometry, false>(choice);
}

template <class Law, class Real>
KernelSet kernel_of_geometry(const KernelChoice& choice) {
    switch (choice.geometry) {
        case Geometry::axisymmetric: return kernel_of_effects<Law, Real, Geometry::axisymmetric>(choice);
        case Geometry::plane_strain: return kernel_of_effects<Law, Real, Geometry::plane_strain>(choice);
        case Geometry::plane_stress: break;
    }
    // A plastic law would need the thickness to follow: scenes refuse it.
    if constexpr (Law::extra_state == 0) return kernel_of_effects<Law, Real, Geometry::plane_stress>(choice);
    return {};
}

}  // namespace percuss::PERCUSS_ISA
