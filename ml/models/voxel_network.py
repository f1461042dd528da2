#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Train the sparse voxel U-net of the library from simulated rooms.

    voxel_network.py ROOMS.npz NETWORK [-steps N] [-voxels N] [-seed N]

ROOMS.npz is what collect_rooms.py writes, NETWORK what loadVoxelNetwork() reads. Needs numpy and torch. A graphics card is
used if there is one: 7,600 steps take 16 minutes on an H100. Without one a step takes half a minute and more.

Convolutions are gathers and products: the rows of the neighbours that a voxel has, times one matrix (submanifold sparse
convolution, Graham et al., CVPR 2018). Rooms are changed at random in each step, as real ones differ from simulated ones.
Beside the classes the network learns where the middle of each voxel's object is.
"""
import argparse
import json
import math
import os
import time
import zlib

import numpy
import torch
from torch import nn
from torch.nn import functional

VOXEL = 0.05  # m
WIDTHS = (32, 48, 64, 96, 96)  # of the levels, from 5 cm voxels to 80 cm
INPUTS = 5  # one, height, offsets of the centroid from the voxel's middle
EPSILON = 1e-3  # of the normalisation
MARGIN, EXTENT = 32, 1024  # cells before the first voxel, cells of an axis


def rows(values, table):
    """values[table], a row of zeros for numbers that are one too large."""
    padded = torch.cat([values, values.new_zeros(1, values.shape[1])])
    return padded[table].flatten(1)


class Near(torch.autograd.Function):
    """3 x 3 x 3 neighbours of each voxel times weights (27 * in, out)."""

    @staticmethod
    def forward(context, values, weights, table):
        context.save_for_backward(values, weights, table)
        return rows(values, table) @ weights

    @staticmethod
    def backward(context, gradient):
        values, weights, table = context.saved_tensors
        of_values = of_weights = None
        if context.needs_input_grad[0]:
            turned = weights.view(27, -1, weights.shape[1]).flip(0).transpose(1, 2).reshape(-1, values.shape[1])
            of_values = rows(gradient, table) @ turned
        if context.needs_input_grad[1]:
            of_weights = rows(values, table).T @ gradient
        return of_values, of_weights, None


class Down(torch.autograd.Function):
    """The eight children of each voxel of the next level times weights (8 * in, out)."""

    @staticmethod
    def forward(context, values, weights, children, slot):
        context.save_for_backward(values, weights, children, slot)
        return rows(values, children) @ weights

    @staticmethod
    def backward(context, gradient):
        values, weights, children, slot = context.saved_tensors
        of_values = (gradient @ weights.T).view(-1, values.shape[1])[slot]
        return of_values, rows(values, children).T @ gradient, None, None


class Up(torch.autograd.Function):
    """Each voxel's parent times the weights (in, 8 * out) of its place among the children."""

    @staticmethod
    def forward(context, values, weights, children, slot):
        context.save_for_backward(values, weights, children, slot)
        return (values @ weights).view(-1, weights.shape[1] // 8)[slot]

    @staticmethod
    def backward(context, gradient):
        values, weights, children, slot = context.saved_tensors
        gathered = rows(gradient, children)
        return gathered @ weights.T, values.T @ gathered, None, None


def unique_keys(keys):
    return torch.unique(keys, sorted=True, return_inverse=True)


def neighbors_of(keys):
    """Place of the 27 neighbours of each key; the number of keys where there is none."""
    table = torch.empty(len(keys), 27, dtype=torch.long, device=keys.device)
    k = 0
    for z in (-1, 0, 1):
        for y in (-1, 0, 1):
            for x in (-1, 0, 1):
                wanted = keys + (z * EXTENT + y) * EXTENT + x
                at = torch.searchsorted(keys, wanted).clamp_(max=len(keys) - 1)
                table[:, k] = torch.where(keys[at] == wanted, at, len(keys))
                k += 1
    return table


def levels_of(keys):
    """Tables of all levels: neighbours, and how voxels lie in those of the next level."""
    levels = []
    for level in range(len(WIDTHS)):
        level_tables = {"near": neighbors_of(keys)}
        if level + 1 < len(WIDTHS):
            x, y, z, room = keys % EXTENT, keys // EXTENT % EXTENT, keys // EXTENT**2 % EXTENT, keys // EXTENT**3
            parents, parent = unique_keys(((room * EXTENT + z // 2) * EXTENT + y // 2) * EXTENT + x // 2)
            slot = parent * 8 + (z % 2) * 4 + (y % 2) * 2 + x % 2
            children = torch.full((len(parents) * 8,), len(keys), dtype=torch.long, device=keys.device)
            children[slot] = torch.arange(len(keys), device=keys.device)
            level_tables.update(children=children.view(-1, 8), slot=slot)
            keys = parents
        levels.append(level_tables)
    return levels


class Weights(nn.Module):
    """A matrix and the normalisation of what it gives to each of some places; met: how many inputs a row usually has."""

    def __init__(self, rows_in, out, met, places=1):
        super().__init__()
        self.weight = nn.Parameter(torch.randn(rows_in, out) * math.sqrt(2 / met))
        self.norm = nn.BatchNorm1d(out // places, eps=EPSILON, momentum=0.02)


class VoxelNetwork(nn.Module):
    """Outputs: scores of the classes, and from the voxel to the middle of its object (m)."""

    def __init__(self, classes):
        super().__init__()
        w = WIDTHS
        self.stem = Weights(27 * INPUTS, w[0], 9 * INPUTS)
        self.first = nn.ModuleList([Weights(27 * c, c, 10 * c) for c in w])
        self.second = nn.ModuleList([Weights(27 * c, c, 10 * c) for c in w])
        self.down = nn.ModuleList([Weights(8 * a, b, 4 * a) for a, b in zip(w, w[1:])])
        self.up = nn.ModuleList([Weights(b, 8 * a, b, 8) for a, b in zip(w, w[1:])])
        self.joined = nn.ModuleList([Weights(27 * 2 * c, c, 20 * c) for c in w[:-1]])
        self.last = nn.Linear(w[0], classes + 3)

    def forward(self, inputs, levels):
        kind = torch.bfloat16 if inputs.is_cuda else torch.float32

        def product(operation, part, values, *tables):
            return part.norm(operation.apply(values, part.weight.to(kind), *tables))

        values = functional.relu(product(Near, self.stem, inputs.to(kind), levels[0]["near"]))
        kept = []
        for k, level in enumerate(levels):
            inner = functional.relu(product(Near, self.first[k], values, level["near"]))
            values = functional.relu(product(Near, self.second[k], inner, level["near"]) + values)
            if k + 1 < len(levels):
                kept.append(values)
                values = functional.relu(product(Down, self.down[k], values, level["children"], level["slot"]))
        for k in reversed(range(len(levels) - 1)):
            values = functional.relu(product(Up, self.up[k], values, levels[k]["children"], levels[k]["slot"]))
            values = functional.relu(product(Near, self.joined[k], torch.cat([values, kept[k]], 1), levels[k]["near"]))
        return self.last(values.float())


def voxelised(points, room):
    """Keys, voxel of each point, inputs without heights."""
    cells = torch.floor(points / VOXEL).long()
    least = torch.full((int(room.max()) + 1, 3), 1 << 40, dtype=torch.long, device=points.device)
    least.scatter_reduce_(0, room[:, None].expand(-1, 3), cells, "amin")
    placed = (cells - least[room] + MARGIN).clamp_(max=EXTENT - 2)
    keys, voxel = unique_keys(((room * EXTENT + placed[:, 2]) * EXTENT + placed[:, 1]) * EXTENT + placed[:, 0])
    count = torch.zeros(len(keys), device=points.device).index_add_(0, voxel, torch.ones_like(points[:, 0]))
    offset = points / VOXEL - cells - 0.5
    offset = torch.zeros(len(keys), 3, device=points.device).index_add_(0, voxel, offset) / count[:, None]
    return keys, voxel, offset


def inputs_of(offset, height):
    return torch.cat([torch.ones_like(height)[:, None], (height / 2).clamp(-0.5, 2)[:, None], offset], 1)


def low_level(z):
    """The height below which a twentieth of the points lies."""
    return torch.quantile(z[torch.randperm(len(z), device=z.device)[:4000]] if len(z) > 4000 else z, 0.05)


class Rooms:
    """Simulated rooms on the device: points, class of each (-1: not to be learned), ranges."""

    def __init__(self, path, device):
        data = numpy.load(path)
        self.names = [str(name) for name in data["names"]]
        self.points = torch.from_numpy(data["points"].astype(numpy.float32) * 0.001).to(device)
        self.classes = torch.from_numpy(data["classes"].astype(numpy.int64)).to(device)
        self.objects = torch.from_numpy(data["objects"].astype(numpy.int64)).to(device)  # 0: the building
        self.ends = numpy.concatenate([[0], numpy.cumsum(data["sizes"])])
        self.captured = data["captured"]
        self.weight = data["counts"].clip(1, 12).astype(float)
        self.weight /= self.weight.sum()
        self.device = device

    def __len__(self):
        return len(self.ends) - 1


def wave(points, room, count, lengths, device):
    """A smooth random field of each room, of deviation 1; lengths in metres."""
    terms = 5
    direction = functional.normalize(torch.randn(count, terms, 3, device=device), dim=2)
    length = torch.empty(count, terms, 1, device=device).uniform_(*lengths)
    phase = torch.rand(count, terms, device=device) * 2 * math.pi
    angles = ((direction * 2 * math.pi / length)[room] * points[:, None, :]).sum(2) + phase[room]
    return torch.sin(angles).sum(1) * math.sqrt(2 / terms)


def draw(rooms, chosen):
    """Points, classes and room of each of some rooms, changed at random as real ones differ."""
    device, count = rooms.device, len(chosen)
    parts = [slice(rooms.ends[c], rooms.ends[c + 1]) for c in chosen]
    points = torch.cat([rooms.points[part] for part in parts])
    classes = torch.cat([rooms.classes[part] for part in parts])
    objects = torch.cat([rooms.objects[part] for part in parts])
    room = torch.repeat_interleave(torch.arange(count, device=device),
                                   torch.tensor([part.stop - part.start for part in parts], device=device))
    captured = torch.from_numpy(rooms.captured[chosen]).to(device)

    def uniform(low, high):
        return torch.empty(count, device=device).uniform_(low, high)

    def some(share):
        return torch.rand(count, device=device) < share

    middle = torch.zeros(count, 3, device=device).index_add_(0, room, points)
    middle /= torch.bincount(room, minlength=count)[:, None]
    middle[:, 2] = torch.stack([low_level(rooms.points[part][:, 2]) for part in parts])
    points = points - middle[room]

    keep = torch.rand(len(points), device=device) < torch.where(some(0.5), uniform(0.3, 1), 1)[room]
    # what was not seen: ceilings of laser scans as in captures, walls above a height, a side, holes
    ceiling = rooms.names.index("ceiling")
    without_ceiling = some(0.5) & ~captured
    keep &= ~((classes == ceiling) & without_ceiling[room])
    cut = torch.where(without_ceiling & some(0.7) | some(0.1), uniform(1.3, 2.9), 100)
    ripple = wave(points, room, count, (1, 5), device)
    keep &= points[:, 2] < cut[room] + ripple * uniform(0.05, 0.4)[room]
    side = uniform(0, 2 * math.pi)[room]
    along = points[:, 0] * torch.cos(side) + points[:, 1] * torch.sin(side)
    keep &= along < torch.where(some(0.2), uniform(0, 2), 100)[room] + 0.2 * ripple
    holes = wave(points, room, count, (0.4, 2.5), device)
    keep &= holes < torch.where(some(0.3), uniform(0.9, 2), 100)[room]
    small = wave(points, room, count, (0.15, 0.6), device)
    keep &= small < torch.where(some(0.2), uniform(1.2, 2.5), 100)[room]
    points, classes, objects, room = points[keep], classes[keep], objects[keep], room[keep]

    # other sizes, warps, noise, tilt, turns
    scale = torch.stack([uniform(0.88, 1.14), uniform(0.88, 1.14), uniform(0.92, 1.08)], 1)
    points = points * scale[room]
    far = torch.where(some(0.6), uniform(0.003, 0.03), 0)
    near = torch.where(some(0.5), uniform(0.001, 0.01), 0)
    points = points + torch.stack([far[room] * wave(points, room, count, (0.8, 4), device) +
                                   near[room] * wave(points, room, count, (0.12, 0.5), device) for _ in range(3)], 1)
    noise = torch.where(some(0.5), uniform(0, 0.015), 0)
    points = points + torch.randn_like(points) * noise[room][:, None]
    tilt = torch.randn(count, 2, device=device) * 0.01
    points[:, 2] += (points[:, :2] * tilt[room]).sum(1)
    turn, mirrored = uniform(0, 2 * math.pi)[room], torch.where(some(0.5), -1.0, 1.0)[room]
    x = (points[:, 0] * torch.cos(turn) - points[:, 1] * torch.sin(turn)) * mirrored
    y = points[:, 0] * torch.sin(turn) + points[:, 1] * torch.cos(turn)
    points = torch.stack([x, y, points[:, 2]], 1) + torch.rand(count, 3, device=device)[room] * VOXEL
    return points, classes, objects, room


def batch(rooms, chosen):
    points, classes, objects, room = draw(rooms, chosen)
    keys, voxel, offset = voxelised(points, room)
    first = torch.full((len(keys),), len(points), dtype=torch.long, device=points.device)
    first.scatter_reduce_(0, voxel, torch.arange(len(points), device=points.device), "amin")
    levels = torch.stack([low_level(points[room == k, 2]) if bool((room == k).any()) else points.new_zeros(())
                          for k in range(len(chosen))])
    levels = levels + torch.randn_like(levels) * 0.05 - (torch.rand_like(levels) < 0.1) * torch.rand_like(levels) * 0.3
    height = points[first, 2] - levels[room[first]]
    _, number = torch.unique(room * (1 << 32) + objects, return_inverse=True)
    count = torch.bincount(number)
    middle = torch.zeros(len(count), 3, device=points.device).index_add_(0, number, points) / count[:, None]
    to_middle = middle[number[first]] - points[first]
    to_middle[objects[first] == 0] = math.nan
    return inputs_of(offset, height), levels_of(keys), classes[first], to_middle


def class_weights(rooms):
    share = numpy.bincount(rooms.classes[rooms.classes >= 0].cpu(), minlength=len(rooms.names)).astype(float)
    share /= share.sum()
    weight = 1 / numpy.sqrt(share + 1e-3)
    weight[share == 0] = 0
    return torch.from_numpy(weight / (weight * share).sum()).float()


def network_bytes(network, names):
    """The network as loadVoxelNetwork() reads it: normalisation within the weights, these in 8 bits."""
    state = {name: value.detach().cpu().double().numpy() for name, value in network.state_dict().items()}
    header = {"classes": names, "widths": WIDTHS, "voxel_size": VOXEL}
    parts = [b"pcl_indoor_voxel_network 1\n", json.dumps(header, separators=(",", ":")).encode() + b"\n"]

    def put(weights, bias):
        factor = numpy.maximum(numpy.abs(weights).max(axis=0) / 127, 1e-12)
        parts.extend([factor.astype("<f4").tobytes(), bias.astype("<f4").tobytes(),
                      numpy.round(weights / factor).astype(numpy.int8).tobytes()])

    def put_layer(name, places=1):
        weights = state[name + ".weight"]  # the places of children lie side by side
        weights = weights.reshape(len(weights), places, -1).transpose(1, 0, 2).reshape(len(weights) * places, -1)
        factor = state[name + ".norm.weight"] / numpy.sqrt(state[name + ".norm.running_var"] + EPSILON)
        put(weights * factor, state[name + ".norm.bias"] - state[name + ".norm.running_mean"] * factor)

    put_layer("stem")
    for k in range(len(WIDTHS)):
        put_layer(f"first.{k}")
        put_layer(f"second.{k}")
    for k in range(len(WIDTHS) - 1):
        put_layer(f"down.{k}")
        put_layer(f"up.{k}", 8)
        put_layer(f"joined.{k}")
    put(state["last.weight"].T, state["last.bias"])
    content = b"".join(parts)
    return content + zlib.crc32(content).to_bytes(4, "little")


def mean(values):
    return float(torch.stack(values[-30:]).mean())


def train(rooms, steps, voxels, seed, device):
    torch.manual_seed(seed)
    random = numpy.random.default_rng(seed)
    network = VoxelNetwork(len(rooms.names)).to(device)
    print(f"{len(rooms)} rooms, {sum(p.numel() for p in network.parameters())} weights", flush=True)
    weight = class_weights(rooms).to(device)
    peak = 4e-3
    optimizer = torch.optim.AdamW(network.parameters(), lr=peak, weight_decay=0.02)
    start, told, losses, errors, shares = time.time(), 0.0, [], [], []
    for step in range(steps):
        for group in optimizer.param_groups:
            group["lr"] = peak * min(1, step / 200, 2 * (1 - step / steps))
        chosen, points = [], 0
        while points < 2.5 * voxels:
            chosen.append(random.choice(len(rooms), p=rooms.weight))
            points += rooms.ends[chosen[-1] + 1] - rooms.ends[chosen[-1]]
        inputs, levels, truth, to_middle = batch(rooms, numpy.array(chosen))
        outputs = network(inputs, levels)
        scores, on_object = outputs[:, :-3], ~torch.isnan(to_middle[:, 0])
        loss = functional.cross_entropy(scores, truth, weight, ignore_index=-1, label_smoothing=0.05)
        error = (outputs[on_object, -3:] - to_middle[on_object]).abs().sum() / (3 * on_object.sum()).clamp(min=1)
        loss = loss + error
        optimizer.zero_grad(set_to_none=True)
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 5)
        optimizer.step()
        if step % 10 == 0:
            is_object = truth > 2
            losses.append(loss.detach())
            errors.append(error.detach())
            shares.append((scores.argmax(1) == truth)[is_object].float().mean())
        if time.time() - told > 20 or step + 1 == steps:
            told = time.time()
            print(f"{(told - start) / 60:5.1f} min, step {step}, {len(chosen)} rooms, {len(truth)} voxels, "
                  f"loss {mean(losses):.3f}, middle {mean(errors):.3f} m, objects {mean(shares):.3f}", flush=True)
    return network.eval()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rooms")
    parser.add_argument("network")
    parser.add_argument("-steps", type=int, default=7600)
    parser.add_argument("-voxels", type=int, default=300000, help="of a step, about")
    parser.add_argument("-seed", type=int, default=1)
    options = parser.parse_args()
    device = "cuda" if torch.cuda.is_available() else "cpu"
    rooms = Rooms(options.rooms, device)
    network = train(rooms, options.steps, options.voxels, options.seed, device)
    with open(options.network + ".new", "wb") as file:
        file.write(network_bytes(network, rooms.names))
    os.replace(options.network + ".new", options.network)


if __name__ == "__main__":
    main()
