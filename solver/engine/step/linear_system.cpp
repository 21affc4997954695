// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Large systems are solved with a supernodal factor, whose order (by minimum degree, or
// within given groups) and pattern CHOLMOD finds, and small ones with CHOLMOD's
// simplicial LLᵀ. The choice depends on the
// operations counted by the analysis and never on measured time, so that a scene is
// solved in the same way in every run. LLᵀ is used instead of LDLᵀ because it stops at
// the first pivot that is not positive, which is how a loose block is found.
//
// The matrix is stored in elimination order, so that a factorisation reads it in
// place; CHOLMOD would permute a copy each time.
//
// The threads of the libraries are deliberately not used here. Those of CHOLMOD would be
// nested in those of the solver and make a thousand blocks five times slower; OpenBLAS
// would split sums according to the number of cores. Large factors are divided by
// `SupernodalFactor` and `SupernodalSolve`.
#include "solver/engine/step/linear_system.h"

#include "solver/engine/step/supernodal_factor.h"
#include "solver/engine/step/supernodal_solve.h"
#include "solver/engine/step/supernodal_update.h"

#include <cblas.h>
#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>

namespace keyblock {

namespace {

/// A pivot below this fraction of its diagonal entry has lost all but four bits to cancellation and is only round-off.
constexpr double pivotFloor = 16.0 * std::numeric_limits<double>::epsilon();

/// Maximum number of ranks of a worthwhile update, over the operations per entry of a factor. With a thousand blocks it
/// amounts to 91 ranks.
constexpr double rankShare = 0.6;

/// Column numbers up to which neighbouring supernodes are merged: always up to the first, and beyond it if the fraction
/// of zeros is small enough. They are larger than CHOLMOD's defaults because a block has six columns: with fewer
/// supernodes, less time is spent on BLAS calls for small matrices.
constexpr std::size_t mergedColumns[] = {12, 24, 48};
constexpr double mergedZeros[] = {0.3, 0.1, 0.05};

/// Operations with an order by groups, over those with an order of minimum degree, below which it is used.
constexpr double groupsPay = 0.9;

/// Operations per entry of a factor from which supernodes are faster than single columns. This is less than CHOLMOD's
/// default of 40, because the six columns of a block have the same pattern. Chains of bolt nodes need fewer operations.
constexpr double supernodesPay = 20.0;

void useOneThread() {
    static const bool done = [] {
        openblas_set_num_threads(1);
        return true;
    }();
    (void)done;
    omp_set_max_active_levels(0);  // setting of the calling thread, therefore repeated at every call
}

}  // namespace

struct LinearSystem::Detail {
    cholmod_common common{};
    cholmod_sparse* matrix = nullptr;  // lower triangle in elimination order, rows sorted within each column
    cholmod_factor* factor = nullptr;
    cholmod_factor* updated = nullptr;  // simplicial factor as LDLᵀ after updates; null: `factor` is up to date
    SupernodalFactor factoring;
    SupernodalSolve solving;
    SupernodalUpdate supernodes;
    cholmod_dense* workX = nullptr;  // kept between solutions, to avoid allocations in a loop of a million steps
    cholmod_dense* workY = nullptr;
    cholmod_dense* workE = nullptr;
    std::vector<double> residual;
    std::vector<double> correction;
    std::vector<double> ordered;  // right-hand side, then solution, in elimination order
    std::vector<int> order;  // unknowns in elimination order
    std::vector<int> place;  // position of each unknown in that order

    Detail() {
        useOneThread();
        cholmod_start(&common);
        common.print = 0;
        common.nmethods = 1;
        common.supernodal = CHOLMOD_AUTO;
        common.supernodal_switch = supernodesPay;
        std::ranges::copy(mergedColumns, common.nrelax);
        std::ranges::copy(mergedZeros, common.zrelax);
        common.final_ll = 1;
        common.quick_return_if_not_posdef = 1;
    }

    ~Detail() {
        release();
        cholmod_finish(&common);
    }

    Detail(const Detail&) = delete;
    Detail& operator=(const Detail&) = delete;

    void release() {
        cholmod_free_sparse(&matrix, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_free_factor(&updated, &common);
        cholmod_free_dense(&workX, &common);
        cholmod_free_dense(&workY, &common);
        cholmod_free_dense(&workE, &common);
    }

    int* columns() const { return static_cast<int*>(matrix->p); }
    int* rows() const { return static_cast<int*>(matrix->i); }
    double* entries() const { return static_cast<double*>(matrix->x); }
    int size() const { return matrix ? static_cast<int>(matrix->nrow) : 0; }

    void requireMemory() const {
        if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
    }

    /// Builds the column pointers and row indices of the lower triangle in the current order, without duplicates, in
    /// time proportional to the number of entries.
    void buildPattern(int n, std::span<const std::pair<int, int>> pairs);

    /// Analyses the pattern, in the order in which it is stored or in an order found by AMD.
    void analyseBy(int ordering);

    /// Analyses the pattern in an order by groups, and takes it instead of the present analysis if it saves enough.
    void tryGroups(std::span<const int> groups);

    /// Prepares supernodal factorisations and updates, and allocates the values of the factor.
    void analyseSupernodes();

    /// Factors the matrix.
    /// \return the column whose pivot is not positive, or −1.
    int factorize();

    /// Adopts the order found by the analysis.
    void takeOrder();

    /// Calls `visit(column, pivot)` for every diagonal entry of L, in elimination order.
    template <class Visit>
    void forEachPivot(Visit visit) const;

    /// Column of L whose pivot is lost in round-off, or −1.
    int lostPivot() const;

    int unknownOfColumn(std::size_t column) const { return order[std::min(column, order.size() - 1)]; }
    int placeOf(int unknown) const { return place[unknown]; }

    void backSubstitute(std::span<const double> rhs, std::span<double> x);
    void solveColumns();

    /// The columns with their row indices in elimination order.
    std::vector<SparseColumn> inOrder(std::span<const SparseColumn> columns) const;

    /// Converts such columns to a sparse matrix.
    cholmod_sparse* sparse(std::span<const SparseColumn> columns);

    /// Add or remove ranks. `updateColumns` expects columns in elimination order and updates a simplicial factor.
    /// \return false if a pivot is no longer positive.
    bool update(bool add, std::span<const SparseColumn> columns);
    bool updateColumns(bool add, std::span<const SparseColumn> columns);
};

void LinearSystem::Detail::buildPattern(int n, std::span<const std::pair<int, int>> pairs) {
    const std::size_t count = n;
    std::vector<int> start(count + 1, 0);
    for (const auto& [i, j] : pairs) ++start[std::min(placeOf(i), placeOf(j)) + 1];
    for (std::size_t k = 0; k < count; ++k) start[k + 1] += start[k] + 1;  // plus the diagonal entry

    std::vector<int> row(start[count]);
    std::vector<int> next(start.begin(), start.end() - 1);
    const auto put = [&](int i, int j) {
        row[next[std::min(i, j)]++] = std::max(i, j);
    };
    for (int k = 0; k < n; ++k) put(k, k);
    for (const auto& [i, j] : pairs) put(placeOf(i), placeOf(j));

    std::vector<int> unique(count + 1, 0);
    auto end = row.begin();
    for (std::size_t k = 0; k < count; ++k) {
        const auto from = row.begin() + start[k];
        const auto to = row.begin() + start[k + 1];
        std::sort(from, to);
        end = std::copy(from, std::unique(from, to), end);
        unique[k + 1] = static_cast<int>(end - row.begin());
    }

    const std::size_t entryCount = unique[count];
    cholmod_free_sparse(&matrix, &common);
    matrix = cholmod_allocate_sparse(count, count, entryCount, 1, 1, -1, CHOLMOD_REAL, &common);
    requireMemory();
    std::copy(unique.begin(), unique.end(), columns());
    std::copy(row.begin(), end, rows());
    std::fill_n(entries(), entryCount, 0.0);
}

void LinearSystem::Detail::analyseBy(int ordering) {
    common.method[0].ordering = ordering;
    common.postorder = ordering != CHOLMOD_NATURAL;
    cholmod_free_factor(&factor, &common);
    factor = cholmod_analyze(matrix, &common);
    requireMemory();
}

void LinearSystem::Detail::tryGroups(std::span<const int> groups) {
    assert(static_cast<int>(groups.size()) == size());
    assert(std::ranges::all_of(groups, [&](int g) { return g >= 0 && g < size(); }));
    const double operations = common.fl;
    std::vector<int> group(groups.begin(), groups.end()), found(groups.size());
    const bool isOrdered = cholmod_camd(matrix, nullptr, 0, group.data(), found.data(), &common) != 0;
    requireMemory();
    if (!isOrdered) return;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 1;
    cholmod_factor* byGroups = cholmod_analyze_p(matrix, found.data(), nullptr, 0, &common);
    requireMemory();
    if (byGroups && common.fl < groupsPay * operations) std::swap(factor, byGroups);
    cholmod_free_factor(&byGroups, &common);
}

void LinearSystem::Detail::analyseSupernodes() {
    cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, factor, &common);
    requireMemory();
    factoring.analyse(*factor);
    solving.analyse(*factor);
    supernodes.analyse(*factor);
}

int LinearSystem::Detail::factorize() {
    if (factor->is_super) return factoring.apply(*matrix, *factor);
    cholmod_factorize(matrix, factor, &common);
    requireMemory();
    return common.status == CHOLMOD_NOT_POSDEF ? static_cast<int>(factor->minor) : -1;
}

void LinearSystem::Detail::takeOrder() {
    const auto* found = static_cast<const int*>(factor->Perm);
    order.assign(found, found + factor->n);
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
}

template <class Visit>
void LinearSystem::Detail::forEachPivot(Visit visit) const {
    const auto* values = static_cast<const double*>(factor->x);
    if (!factor->is_super) {
        const auto* start = static_cast<const int*>(factor->p);
        for (std::size_t column = 0; column < factor->n; ++column) visit(column, values[start[column]]);
        return;
    }
    const auto* super = static_cast<const int*>(factor->super);
    const auto* rowStart = static_cast<const int*>(factor->pi);
    const auto* valueStart = static_cast<const int*>(factor->px);
    for (std::size_t s = 0; s < factor->nsuper; ++s) {
        const int height = rowStart[s + 1] - rowStart[s];
        for (int column = super[s]; column < super[s + 1]; ++column)
            visit(static_cast<std::size_t>(column), values[valueStart[s] + (column - super[s]) * (height + 1)]);
    }
}

int LinearSystem::Detail::lostPivot() const {
    int lost = -1;
    forEachPivot([&](std::size_t column, double pivot) {
        // The diagonal entry of A comes first in its column; !(…) also catches NaN.
        const double diagonal = entries()[columns()[column]];
        if (lost < 0 && !(pivot * pivot > pivotFloor * diagonal)) lost = static_cast<int>(column);
    });
    return lost;
}

void LinearSystem::Detail::backSubstitute(std::span<const double> rhs, std::span<double> x) {
    for (std::size_t k = 0; k < order.size(); ++k) ordered[k] = rhs[order[k]];
    if (factor->is_super) solving.apply(*factor, ordered);
    else solveColumns();
    for (std::size_t k = 0; k < order.size(); ++k) x[order[k]] = ordered[k];
}

/// Solves for `ordered` with a simplicial factor, in place.
void LinearSystem::Detail::solveColumns() {
    cholmod_dense b{};
    b.nrow = b.d = b.nzmax = ordered.size();
    b.ncol = 1;
    b.x = ordered.data();
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A, updated ? updated : factor, &b, nullptr, &workX, nullptr, &workY, &workE, &common);
    requireMemory();
    std::copy_n(static_cast<const double*>(workX->x), ordered.size(), ordered.begin());
}

std::vector<SparseColumn> LinearSystem::Detail::inOrder(std::span<const SparseColumn> columns) const {
    std::vector<SparseColumn> result(columns.begin(), columns.end());
    for (SparseColumn& column : result) {
        for (auto& entry : column) entry.first = placeOf(entry.first);
        std::sort(column.begin(), column.end());
    }
    return result;
}

cholmod_sparse* LinearSystem::Detail::sparse(std::span<const SparseColumn> columns) {
    std::size_t entryCount = 0;
    for (const SparseColumn& column : columns) entryCount += column.size();
    cholmod_sparse* result = cholmod_allocate_sparse(factor->n, columns.size(), entryCount, 1, 1, 0, CHOLMOD_REAL, &common);
    requireMemory();
    auto* start = static_cast<int*>(result->p);
    auto* row = static_cast<int*>(result->i);
    auto* value = static_cast<double*>(result->x);
    int at = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        start[c] = at;
        for (const auto& [i, x] : columns[c]) row[at] = i, value[at++] = x;
    }
    start[columns.size()] = at;
    return result;
}

bool LinearSystem::Detail::update(bool add, std::span<const SparseColumn> columns) {
    if (columns.empty()) return true;
    useOneThread();
    const std::vector<SparseColumn> ranks = inOrder(columns);
    return factor->is_super ? supernodes.apply(*factor, add, ranks) : updateColumns(add, ranks);
}

bool LinearSystem::Detail::updateColumns(bool add, std::span<const SparseColumn> columns) {
    if (!updated) {
        updated = cholmod_copy_factor(factor, &common);
        requireMemory();
        cholmod_change_factor(CHOLMOD_REAL, 0, 0, 0, 1, updated, &common);
        requireMemory();
    }
    cholmod_sparse* ranks = sparse(columns);
    const bool done = cholmod_updown(add ? 1 : 0, ranks, updated, &common) != 0;
    cholmod_free_sparse(&ranks, &common);
    requireMemory();
    if (!done || common.status == CHOLMOD_NOT_POSDEF) return false;
    const auto* start = static_cast<const int*>(updated->p);
    const auto* values = static_cast<const double*>(updated->x);
    for (std::size_t column = 0; column < updated->n; ++column)
        if (!(values[start[column]] > 0.0)) return false;  // also for NaN
    return true;
}

LinearSystem::LinearSystem() : detail_(std::make_unique<Detail>()) {}
LinearSystem::~LinearSystem() = default;
LinearSystem::LinearSystem(LinearSystem&&) noexcept = default;
LinearSystem& LinearSystem::operator=(LinearSystem&&) noexcept = default;

void LinearSystem::analyse(int n, std::span<const std::pair<int, int>> entries, std::span<const int> groups) {
    Detail& d = *detail_;
    useOneThread();
    d.release();
    d.place.resize(n);
    std::iota(d.place.begin(), d.place.end(), 0);
    d.buildPattern(n, entries);
    d.analyseBy(CHOLMOD_AMD);
    if (!groups.empty()) d.tryGroups(groups);
    d.takeOrder();
    d.buildPattern(n, entries);
    d.analyseBy(CHOLMOD_NATURAL);
    if (d.factor->is_super) d.analyseSupernodes();
    d.ordered.resize(n);
    d.residual.resize(n);
    d.correction.resize(n);
}

int LinearSystem::size() const { return detail_->size(); }

int LinearSystem::slot(int i, int j) const {
    const Detail& d = *detail_;
    const int row = std::max(d.placeOf(i), d.placeOf(j));
    const int column = std::min(d.placeOf(i), d.placeOf(j));
    const int* begin = d.rows() + d.columns()[column];
    const int* end = d.rows() + d.columns()[column + 1];
    const int* place = std::lower_bound(begin, end, row);
    assert(place != end && *place == row);
    return static_cast<int>(place - d.rows());
}

std::span<double> LinearSystem::values() {
    const Detail& d = *detail_;
    if (!d.matrix) return {};
    return {d.entries(), static_cast<std::size_t>(d.columns()[d.size()])};
}

void LinearSystem::clear() { std::ranges::fill(values(), 0.0); }

int LinearSystem::factor() {
    Detail& d = *detail_;
    useOneThread();
    if (d.size() == 0) return -1;
    cholmod_free_factor(&d.updated, &d.common);
    if (const int loose = d.factorize(); loose >= 0) return d.unknownOfColumn(static_cast<std::size_t>(loose));
    const int lost = d.lostPivot();
    return lost < 0 ? -1 : d.unknownOfColumn(static_cast<std::size_t>(lost));
}

bool LinearSystem::addRanks(std::span<const SparseColumn> columns) { return detail_->update(true, columns); }
bool LinearSystem::takeRanks(std::span<const SparseColumn> columns) { return detail_->update(false, columns); }

int LinearSystem::worthwhileRanks() const {
    if (!detail_->factor || detail_->size() == 0) return 0;
    return static_cast<int>(rankShare * detail_->common.fl / std::max(1.0, detail_->common.lnz));
}

void LinearSystem::solve(std::span<const double> rhs, std::span<double> x, int refinements) {
    Detail& d = *detail_;
    useOneThread();
    if (d.size() == 0) return;
    d.backSubstitute(rhs, x);
    for (int round = 0; round < refinements; ++round) {
        multiply(x, d.residual);
        for (std::size_t k = 0; k < x.size(); ++k) d.residual[k] = rhs[k] - d.residual[k];
        d.backSubstitute(d.residual, d.correction);
        for (std::size_t k = 0; k < x.size(); ++k) x[k] += d.correction[k];
    }
}

void LinearSystem::multiply(std::span<const double> x, std::span<double> y) const {
    const Detail& d = *detail_;
    std::ranges::fill(y, 0.0);
    for (int column = 0; column < d.size(); ++column) {
        const int diagonal = d.columns()[column];
        const std::size_t j = d.unknownOfColumn(static_cast<std::size_t>(column));
        double sum = d.entries()[diagonal] * x[j];
        for (int k = diagonal + 1; k < d.columns()[column + 1]; ++k) {
            const std::size_t i = d.unknownOfColumn(static_cast<std::size_t>(d.rows()[k]));
            y[i] += d.entries()[k] * x[j];
            sum += d.entries()[k] * x[i];
        }
        y[j] += sum;
    }
}

double LinearSystem::factorEntries() const { return detail_->factor ? detail_->common.lnz : 0.0; }

}  // namespace keyblock
