#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Long Markov chains on the posterior of small nets, by code that shares nothing with taut.

    python3 posterior_chains.py hypar34.json hypar44.json -o ../../tests/data/posterior_reference.json

takes the nets of `taut example hypar:3x4` and `hypar:4x4`, draws lengths and a survey, with and without a
hidden node, and samples the posterior of the lengths

    p(d | y)  ~  p(d)  exp(-|y - r(d)|^2 / (2 noise^2))

with r(d) the exact form: many random-walk Metropolis chains side by side, one direction of the
linearised posterior at a time. Nothing is linearised in what is sampled. The prior p(d) is uniform, or a
mixture over scales and shapes, (hyperprior) of docs/theory.md: those are then drawn given d, from
their exact conditional distribution on a fine grid. Needs NumPy.
"""
import argparse
import json
import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # of many small matrices threads take longer
import numpy as np

CHAINS = 48


class Net:
    def __init__(self, path):
        data = json.load(open(path))
        self.nodes = np.array(data["nodes"], float)
        self.edges = np.array(data["edges"])
        m = len(self.edges)
        self.stiffness = np.broadcast_to(np.array(data["axial_stiffness"], float), m).copy()
        self.nominal = np.array(data["unstressed_lengths"], float)
        supports = set(data["supports"])
        self.free = np.array([i for i in range(len(self.nodes)) if i not in supports])
        adjustable = set(data.get("adjustable", [e for e in range(m) if supports & set(self.edges[e])]))
        self.interior = np.array([e for e in range(m) if e not in adjustable])
        column = -np.ones(len(self.nodes), int)
        column[self.free] = np.arange(len(self.free))
        self.ends = column[self.edges]

    def runs(self):
        """Edges that go on straight through free nodes, turning by less than 30 degrees; at least two."""
        group = np.arange(len(self.edges))
        for node in self.free:
            at = np.flatnonzero((self.edges == node).any(axis=1))
            way = {e: self.nodes[self.edges[e].sum() - node] - self.nodes[node] for e in at}
            pairs = [(way[a] @ way[b] / np.linalg.norm(way[a]) / np.linalg.norm(way[b]), a, b) for a in at for b in at if a < b]
            taken = set()
            for cosine, a, b in sorted(pairs):
                if cosine < -0.866 and not {a, b} & taken:
                    taken |= {a, b}
                    group[group == group[b]] = group[a]
        return [np.flatnonzero(group == g) for g in np.unique(group) if np.sum(group == g) > 1]

    def lengths(self, d):
        l0 = np.tile(self.nominal, (len(d), 1))
        l0[:, self.interior] += d
        return l0

    def state(self, r, l0):
        """Energy, gradient (k x n x 3), unit vectors, lengths."""
        v = r[:, self.edges[:, 0]] - r[:, self.edges[:, 1]]
        length = np.linalg.norm(v, axis=2)
        stretch = np.maximum(length - l0, 0.0)
        energy = 0.5 * np.sum(self.stiffness / l0 * stretch**2, axis=1)
        tension = self.stiffness * stretch / l0
        u = v / length[:, :, None]
        force = np.zeros_like(r)
        for e, (s, t) in enumerate(self.edges):
            force[:, s] += tension[:, e, None] * u[:, e]
            force[:, t] -= tension[:, e, None] * u[:, e]
        return energy, force[:, self.free], u, length, tension

    def hessian(self, u, length, tension, l0):
        k, n = len(length), len(self.free)
        H = np.zeros((k, n, 3, n, 3))
        axial = np.where(tension > 0.0, self.stiffness / l0, 0.0)
        uu = u[:, :, :, None] * u[:, :, None, :]
        blocks = axial[:, :, None, None] * uu + (tension / length)[:, :, None, None] * (np.eye(3) - uu)
        for e, (s, t) in enumerate(self.ends):
            for a in (s, t):
                if a >= 0:
                    H[:, a, :, a, :] += blocks[:, e]
            if s >= 0 and t >= 0:
                H[:, s, :, t, :] -= blocks[:, e]
                H[:, t, :, s, :] -= blocks[:, e]
        return H.reshape(k, 3 * n, 3 * n)

    def forms(self, d, start):
        """Minimisers of the energy (Newton, halved steps), and whether each was found."""
        r = start.copy()
        l0 = self.lengths(d)
        n3 = 3 * len(self.free)
        shift = 1e-9 * np.mean(self.stiffness / self.nominal)
        found = np.zeros(len(d), bool)
        for _ in range(200):
            active = np.flatnonzero(~found)
            energy, force, u, length, tension = self.state(r[active], l0[active])
            size = np.abs(force).max(axis=(1, 2)) / np.maximum(tension.mean(axis=1), 1e-3)
            found[active[size < 1e-9]] = True
            keep = size >= 1e-9
            active = active[keep]
            if not len(active):
                break
            H = self.hessian(u[keep], length[keep], tension[keep], l0[active])
            H[:, np.arange(n3), np.arange(n3)] += shift
            step = -np.linalg.solve(H, force[keep].reshape(len(active), n3, 1))[..., 0]
            slope = np.einsum("ki,ki->k", step, force[keep].reshape(len(active), n3))
            part = np.ones(len(active))
            for _ in range(40):
                trial = r[active].copy()
                trial[:, self.free] += (part[:, None] * step).reshape(len(active), -1, 3)
                now = self.state(trial, l0[active])[0]
                bad = now > energy[keep] + 1e-4 * part * slope + 1e-14 * np.abs(energy[keep])
                if not bad.any():
                    break
                part[bad] *= 0.5
            r[active] = trial
        return r, found

    def rates(self, r, l0):
        """J = dr/dd (3 n_I x m_I) at one form."""
        _, _, u, length, tension = self.state(r[None], l0[None])
        H = self.hessian(u, length, tension, l0[None])[0]
        H += 1e-12 * np.trace(H) / len(H) * np.eye(len(H))
        B = np.zeros((len(H), len(self.interior)))
        for k, e in enumerate(self.interior):
            if tension[0, e] > 0.0:
                b = self.stiffness[e] * length[0, e] / l0[e] ** 2 * u[0, e]
                for node, sign in zip(self.ends[e], (1.0, -1.0)):
                    if node >= 0:
                        B[3 * node : 3 * node + 3, k] += sign * b
        return np.linalg.solve(H, B)

    def tensions(self, r, l0):
        return self.state(r, l0)[4]


class Uniform:
    """One prior for all chains: |d_k| <= bound."""

    def __init__(self, bound):
        self.bound = bound
        self.variance = bound**2 / 3.0

    def start(self, chains):
        pass

    def logs(self, d, chains):
        return np.where((np.abs(d) <= self.bound).all(axis=1), 0.0, -np.inf)

    def renew(self, d, spans, rng):
        """Lengths of slack edges: any that the form spans is as likely, and moves nothing."""
        slack = d > spans
        low = np.maximum(spans[slack], -self.bound)
        d[slack] = low + (self.bound - low) * rng.random(len(low))

    def state(self):
        return np.zeros((CHAINS, 2))


class Mixture:
    """A prior of each chain, docs/theory.md (hyperprior), (length-trend): log-normal in the standard deviation of e around
    `std`, uniform or normal; d = e + G b, where b are the mean of all and a scale of each run of cable."""

    MEAN_WIDTH = 0.5
    RUN_WIDTHS = np.array([1e-6, 0.25, 0.5, 1.0, 2.0])  # the first stands for none
    RUN_WEIGHTS = np.array([0.1, 0.225, 0.225, 0.225, 0.225])

    def __init__(self, net, std, factor, uniform_probability):
        self.grid = np.log(std) + np.log(factor) * np.linspace(-5.0, 5.0, 2001)
        self.log_scale = -0.5 * np.linspace(-5.0, 5.0, 2001) ** 2
        self.log_shape = np.log([uniform_probability, 1.0 - uniform_probability])
        self.variance = std**2
        lengths = net.nominal[net.interior]
        in_run = [np.isin(net.interior, run) for run in net.runs()]
        # Scales are of an edge of mean length: all of b are lengths.
        self.G = np.column_stack([np.ones(len(lengths))] + [one * lengths / lengths.mean() for one in in_run])

    def start(self, chains):
        self.std = np.full(chains, np.sqrt(self.variance))
        self.uniform = np.zeros(chains, bool)
        self.b = np.zeros((chains, self.G.shape[1]))
        self.width = np.full(chains, 2)

    def own(self, d, chains):
        return d - self.b[chains] @ self.G.T

    def logs(self, d, chains):
        return self.logs_of(self.own(d, chains), chains)

    def logs_of(self, e, chains):
        std = self.std[chains]
        inside = (np.abs(e) <= np.sqrt(3.0) * std[:, None]).all(axis=1)
        normal = -0.5 * np.sum(e**2, axis=1) / std**2
        return np.where(self.uniform[chains], np.where(inside, 0.0, -np.inf), normal)

    def widths_of_b(self):
        return np.column_stack([np.full(len(self.std), self.MEAN_WIDTH)] +
                               [self.RUN_WIDTHS[self.width]] * (self.G.shape[1] - 1))

    def renew_common(self, d, rng):
        """b at fixed d: Metropolis steps of one component at a time, and the width of the runs."""
        everyone = np.arange(len(d))
        for _ in range(10):
            stds = self.widths_of_b() * self.std[:, None]
            for k in range(self.G.shape[1]):
                own = self.own(d, everyone)
                change = 0.7 * stds[:, k] * rng.standard_normal(len(d)) * rng.choice([0.1, 0.3, 1.0], len(d))
                gain = self.logs_of(own - change[:, None] * self.G[:, k], everyone) - self.logs_of(own, everyone)
                gain -= 0.5 * ((self.b[:, k] + change) ** 2 - self.b[:, k] ** 2) / stds[:, k] ** 2
                self.b[:, k] += np.where(np.log(rng.random(len(d))) < gain, change, 0.0)
            # The width with standardised scales kept: d moves nothing, e does.
            new = rng.choice(len(self.RUN_WIDTHS), len(d), p=self.RUN_WEIGHTS)
            ratio = self.RUN_WIDTHS[new] / self.RUN_WIDTHS[self.width]
            before, old_b = self.logs(d, everyone), self.b.copy()
            self.b[:, 1:] *= ratio[:, None]
            take = np.log(rng.random(len(d))) < self.logs(d, everyone) - before
            self.b[~take] = old_b[~take]
            self.width = np.where(take, new, self.width)

    def renew(self, d, spans, rng):
        self.renew_common(d, rng)
        e = self.own(d, np.arange(len(d)))
        m, r = d.shape[1], self.b.shape[1]
        std = np.exp(self.grid)
        bound = np.abs(e).max(axis=1)[:, None] <= np.sqrt(3.0) * std
        uniform = np.where(bound, -m * np.log(2.0 * np.sqrt(3.0) * std), -np.inf)
        squares = np.sum(e**2, axis=1)[:, None]
        normal = -m * np.log(np.sqrt(2.0 * np.pi) * std) - 0.5 * squares / std**2
        of_b = -r * np.log(std) - 0.5 * np.sum((self.b / self.widths_of_b()) ** 2, axis=1)[:, None] / std**2
        logs = np.concatenate([uniform + of_b + self.log_shape[0], normal + of_b + self.log_shape[1]], axis=1)
        logs += np.tile(self.log_scale, 2)
        # Gumbel's trick draws from unnormalised logarithms.
        drawn = np.argmax(logs + rng.gumbel(size=logs.shape), axis=1)
        self.uniform = drawn < len(std)
        self.std = std[drawn % len(std)]

    def state(self):
        return np.column_stack([self.std, self.uniform])


def sample(net, y, seen, noise, prior, sweeps, rng):
    """Chains, thinned: length deviations, tensions, standard deviation and shape of the prior."""
    m = len(net.interior)

    def energy(r):
        return 0.5 * np.sum((r[:, seen] - y[seen]) ** 2, axis=(1, 2)) / noise**2

    d = np.zeros((CHAINS, m))
    prior.start(CHAINS)
    r, ok = net.forms(d, np.tile(net.nodes, (CHAINS, 1, 1)))
    assert ok.all()
    everyone = np.arange(CHAINS)
    U = energy(r) - prior.logs(d, everyone)
    rows = np.flatnonzero(np.isin(net.free, seen))
    rows = (3 * rows[:, None] + np.arange(3)).ravel()
    kept_d, kept_t, kept_p = [], [], []
    scale = np.ones(m)
    warm = sweeps // 5
    directions = None
    for sweep in range(warm + sweeps):
        if sweep % 50 == 0 and sweep <= warm:
            # The directions of the linearised posterior, over some of the chains.
            P = np.eye(m) / prior.variance
            for c in range(0, CHAINS, 8):
                J = net.rates(r[c], net.lengths(d[c : c + 1])[0])[rows]
                P += J.T @ J / noise**2 / (CHAINS // 8)
            values, vectors = np.linalg.eigh(P)
            directions = (vectors / np.sqrt(values)).T
        for k in rng.permutation(m):
            step = scale[k] * 2.4 * rng.standard_normal(CHAINS)[:, None] * directions[k]
            new = d + step
            logs = prior.logs(new, everyone)
            inside = np.flatnonzero(np.isfinite(logs))
            threshold = np.log(rng.random(CHAINS))
            accepted = 0
            if len(inside):
                found, ok = net.forms(new[inside], r[inside])
                new_U = np.where(ok, energy(found) - logs[inside], np.inf)
                take = threshold[inside] < U[inside] - new_U
                who = inside[take]
                d[who], r[who], U[who] = new[who], found[take], new_U[take]
                accepted = len(who)
            if sweep < warm:
                scale[k] *= np.exp(0.2 * (accepted / CHAINS - 0.4))
        spans = net.state(r, net.lengths(d))[3][:, net.interior] - net.nominal[net.interior]
        prior.renew(d, spans, rng)
        U = energy(r) - prior.logs(d, everyone)
        if sweep >= warm and sweep % 5 == 0:
            kept_p.append(prior.state())
            kept_d.append(d.copy())
            kept_t.append(net.tensions(r, net.lengths(d)))
    return np.array(kept_d), np.array(kept_t), np.array(kept_p)


def r_hat(values):
    """Split R-hat over chains (draws x chains x quantities), the largest."""
    n = len(values) // 2
    halves = np.concatenate([values[:n], values[n : 2 * n]], axis=1)
    within = halves.var(axis=0, ddof=1).mean(axis=0)
    between = halves.mean(axis=0).var(axis=0, ddof=1)
    return float(np.sqrt((n - 1) / n + between / np.maximum(within, 1e-300)).max())


def rounded(values):
    return [float(f"{v:.7g}") for v in np.ravel(values)]


def case(name, net, true_bound, given, noise, hidden, sweeps, seed):
    """given: a uniform prior's bound; or the standard deviation, factor and probability of a Mixture."""
    rng = np.random.default_rng(seed)
    truth = rng.uniform(-true_bound, true_bound, len(net.interior))
    form, ok = net.forms(truth[None], net.nodes[None])
    assert ok.all()
    y = form[0].copy()
    y[net.free] += noise * rng.standard_normal((len(net.free), 3))
    seen = np.array([i for i in net.free if i not in hidden])
    is_mixture = isinstance(given, tuple)
    prior = Mixture(net, *given) if is_mixture else Uniform(given)
    d, t, p = sample(net, y, seen, noise, prior, sweeps, rng)
    flat_d, flat_t, flat_p = (x.reshape(-1, x.shape[2]) for x in (d, t, p))
    print(f"{name}: R-hat {r_hat(d):.3f} lengths, {r_hat(t):.3f} tensions, {r_hat(p):.3f} prior, {len(flat_d)} draws", flush=True)
    result = {
        "name": name,
        "nodes": net.nodes.tolist(),
        "edges": net.edges.tolist(),
        "free": net.free.tolist(),
        "interior": net.interior.tolist(),
        "axial_stiffness": rounded(net.stiffness),
        "unstressed_lengths": net.nominal.tolist(),
        "noise": noise,
        "hidden": list(hidden),
        "survey": y.tolist(),
        "truth": rounded(truth),
        "r_hat": max(r_hat(d), r_hat(t), r_hat(p)),
        "mean": rounded(flat_d.mean(axis=0)),
        "std": rounded(flat_d.std(axis=0)),
        "tension_mean": rounded(flat_t.mean(axis=0)),
        "tension_std": rounded(flat_t.std(axis=0)),
        "tension_lower": rounded(np.quantile(flat_t, 0.025, axis=0)),
        "tension_upper": rounded(np.quantile(flat_t, 0.975, axis=0)),
        "slack_probability": rounded((flat_t <= 0.0).mean(axis=0)),
    }
    if not is_mixture:
        return result | {"bound": given}
    return result | {
        "given": given[0] * np.sqrt(3.0) if given[1] < 2.0 else None,
        "lower": rounded(np.quantile(flat_d, 0.025, axis=0)),
        "upper": rounded(np.quantile(flat_d, 0.975, axis=0)),
        "prior_std": float(flat_p[:, 0].mean()),
        "prior_std_std": float(flat_p[:, 0].std()),
        "uniform_probability": float(flat_p[:, 1].mean()),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("nets", nargs=2, help="net files: taut example hypar:3x4 -o net.json, hypar:4x4")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--sweeps", type=int, default=1500)
    arguments = parser.parse_args()
    net, other = map(Net, arguments.nets)
    inner = int(net.free[len(net.free) // 2])

    def uniform(bound, factor, probability):
        return bound / np.sqrt(3.0), factor, probability

    cases = [
        case("all nodes", net, 0.005, 0.005, 0.0005, [], arguments.sweeps, 1),
        case("a hidden node", net, 0.005, 0.005, 0.0005, [inner], arguments.sweeps, 2),
        case("slack edges", net, 0.02, 0.02, 0.0005, [], arguments.sweeps, 6),
        case("a prior given", net, 0.005, uniform(0.005, 1.5, 0.75), 0.0005, [], arguments.sweeps // 3, 3),
        case("a prior given too narrow", other, 0.003, uniform(0.002, 1.5, 0.75), 0.0005, [], arguments.sweeps // 3, 4),
        case("no prior given", other, 0.002, uniform(0.005, 2.5, 0.5), 0.0005, [], arguments.sweeps // 3, 5),
    ]
    with open(arguments.output, "w") as file:
        lines = ",\n".join(json.dumps(one) for one in cases)
        file.write(f'{{"made_by": "benchmarks/reference/posterior_chains.py", "cases": [\n{lines}]}}\n')


if __name__ == "__main__":
    main()
