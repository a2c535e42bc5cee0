#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Long Markov chains on the posterior of small nets, by code that shares nothing with taut.

    python3 posterior_chains.py net.json -o ../../tests/data/posterior_reference.json

takes the net of `taut example hypar:3x4`, draws lengths and a survey, with and without a hidden
node, and samples the posterior of the lengths

    p(d | y)  ~  [ |d_k| <= bound ]  exp(-|y - r(d)|^2 / (2 noise^2))

with r(d) the exact form: many random-walk Metropolis chains side by side, one direction of the
linearised posterior at a time. Nothing is linearised in what is sampled. Needs NumPy.
"""
import argparse
import json

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


def sample(net, y, seen, noise, bound, start, sweeps, rng):
    """Chains, thinned: length deviations, tensions."""
    m = len(net.interior)

    def energy(r):
        return 0.5 * np.sum((r[:, seen] - y[seen]) ** 2, axis=(1, 2)) / noise**2

    d = np.tile(start, (CHAINS, 1))
    r, ok = net.forms(d, np.tile(net.nodes, (CHAINS, 1, 1)))
    assert ok.all()
    U = energy(r)
    rows = np.flatnonzero(np.isin(net.free, seen))
    rows = (3 * rows[:, None] + np.arange(3)).ravel()
    kept_d, kept_t = [], []
    scale = np.ones(m)
    warm = sweeps // 5
    directions = None
    for sweep in range(warm + sweeps):
        if sweep % 50 == 0 and sweep <= warm:
            # The directions of the linearised posterior, over some of the chains.
            P = np.eye(m) * 3.0 / bound**2
            for c in range(0, CHAINS, 8):
                J = net.rates(r[c], net.lengths(d[c : c + 1])[0])[rows]
                P += J.T @ J / noise**2 / (CHAINS // 8)
            values, vectors = np.linalg.eigh(P)
            directions = (vectors / np.sqrt(values)).T
        for k in rng.permutation(m):
            step = scale[k] * 2.4 * rng.standard_normal(CHAINS)[:, None] * directions[k]
            new = d + step
            inside = np.flatnonzero((np.abs(new) <= bound).all(axis=1))
            threshold = np.log(rng.random(CHAINS))
            accepted = 0
            if len(inside):
                found, ok = net.forms(new[inside], r[inside])
                new_U = np.where(ok, energy(found), np.inf)
                take = threshold[inside] < U[inside] - new_U
                who = inside[take]
                d[who], r[who], U[who] = new[who], found[take], new_U[take]
                accepted = len(who)
            if sweep < warm:
                scale[k] *= np.exp(0.2 * (accepted / CHAINS - 0.4))
        if sweep >= warm and sweep % 5 == 0:
            kept_d.append(d.copy())
            kept_t.append(net.tensions(r, net.lengths(d)))
    return np.array(kept_d), np.array(kept_t)


def r_hat(values):
    """Split R-hat over chains (draws x chains x quantities), the largest."""
    n = len(values) // 2
    halves = np.concatenate([values[:n], values[n : 2 * n]], axis=1)
    within = halves.var(axis=0, ddof=1).mean(axis=0)
    between = halves.mean(axis=0).var(axis=0, ddof=1)
    return float(np.sqrt((n - 1) / n + between / np.maximum(within, 1e-300)).max())


def rounded(values):
    return [float(f"{v:.7g}") for v in np.ravel(values)]


def case(name, net, bound, noise, hidden, sweeps, seed):
    rng = np.random.default_rng(seed)
    truth = rng.uniform(-bound, bound, len(net.interior))
    form, ok = net.forms(truth[None], net.nodes[None])
    assert ok.all()
    y = form[0].copy()
    y[net.free] += noise * rng.standard_normal((len(net.free), 3))
    seen = np.array([i for i in net.free if i not in hidden])
    d, t = sample(net, y, seen, noise, bound, np.zeros(len(net.interior)), sweeps, rng)
    flat_d, flat_t = d.reshape(-1, d.shape[2]), t.reshape(-1, t.shape[2])
    print(f"{name}: R-hat {r_hat(d):.3f} lengths, {r_hat(t):.3f} tensions, {len(flat_d)} draws", flush=True)
    return {
        "name": name,
        "nodes": net.nodes.tolist(),
        "edges": net.edges.tolist(),
        "free": net.free.tolist(),
        "interior": net.interior.tolist(),
        "axial_stiffness": rounded(net.stiffness),
        "unstressed_lengths": net.nominal.tolist(),
        "bound": bound,
        "noise": noise,
        "hidden": list(hidden),
        "survey": y.tolist(),
        "truth": rounded(truth),
        "r_hat": max(r_hat(d), r_hat(t)),
        "mean": rounded(flat_d.mean(axis=0)),
        "std": rounded(flat_d.std(axis=0)),
        "tension_mean": rounded(flat_t.mean(axis=0)),
        "tension_std": rounded(flat_t.std(axis=0)),
        "tension_lower": rounded(np.quantile(flat_t, 0.025, axis=0)),
        "tension_upper": rounded(np.quantile(flat_t, 0.975, axis=0)),
        "slack_probability": rounded((flat_t <= 0.0).mean(axis=0)),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("net", help="net file: taut example hypar:3x4 -o net.json")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--sweeps", type=int, default=1500)
    arguments = parser.parse_args()
    net = Net(arguments.net)
    inner = int(net.free[len(net.free) // 2])
    cases = [
        case("all nodes", net, 0.005, 0.0005, [], arguments.sweeps, 1),
        case("a hidden node", net, 0.005, 0.0005, [inner], arguments.sweeps, 2),
    ]
    with open(arguments.output, "w") as file:
        lines = ",\n".join(json.dumps(one) for one in cases)
        file.write(f'{{"made_by": "benchmarks/reference/posterior_chains.py", "cases": [\n{lines}]}}\n')


if __name__ == "__main__":
    main()
