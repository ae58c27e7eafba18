// What their many pairs did to large bodies that move, a workgroup a body: its lanes share the pairs
// among themselves and add up what each has, always in the same order. Needs common/index, rows.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> pairs_of: PairsOf;
@group(0) @binding(2) var<storage, read> pair_starts: array<u32>;
@group(0) @binding(3) var<storage, read> large_pairs: array<u32>;
@group(0) @binding(4) var<storage, read> touches: array<Contact>;
@group(0) @binding(5) var<storage, read> presses: array<Pressed>;
@group(0) @binding(6) var<storage, read_write> totals: array<Total>;
@group(0) @binding(7) var<storage, read> status: array<u32>;

const LANES: u32 = 64u;

var<workgroup> sums: array<Total, LANES>;

fn plus(one: Total, other: Total) -> Total {
    var sum = one;
    sum.linear += other.linear;
    sum.counts += other.counts;
    sum.touches += other.touches;
    sum.angular += other.angular;
    sum.bounces += other.bounces;
    sum.stays_linear += other.stays_linear;
    sum.stays_angular += other.stays_angular;
    sum.push += other.push;
    sum.push_angular += other.push_angular;
    return sum;
}

// What a pair did to its body on this side.
fn of_row(row: u32, side: u32) -> Total {
    let sign = select(-1.0, 1.0, side == 1u);
    let angular = presses[row].turning[2u * side];
    var total: Total;
    total.linear = sign * presses[row].linear;
    total.counts = presses[row].counts;
    total.touches = presses[row].counts;
    total.angular = angular.xyz;
    total.bounces = presses[row].bounces;
    total.stays_linear = angular.w * total.linear;
    total.stays_angular = angular.w * angular.xyz;
    total.push = sign * presses[row].push;
    total.push_angular = presses[row].turning[2u * side + 1u].xyz;
    return total;
}

// ANCHOR: large
@compute @workgroup_size(LANES)
fn pair_large(
    @builtin(workgroup_id) group: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let large = group_index(group);
    var sum: Total;
    if large < pairs_of.larges && status[HALTED] == 0u {
        let list = (pairs_of.kinds + large) * grid.rows;
        let before = pair_starts[pairs_of.kinds * grid.rows];
        let first = pair_starts[list] - before;
        let end = pair_starts[list + grid.rows] - before;
        for (var at = first + lane; at < end; at += LANES) {
            let entry = large_pairs[at];
            if touches[entry >> 1u].points > 0u {
                sum = plus(sum, of_row(pairs_of.before + (entry >> 1u), entry & 1u));
            }
        }
    }
    sums[lane] = sum;
    for (var reach = LANES / 2u; reach > 0u; reach /= 2u) {
        workgroupBarrier();
        if lane < reach {
            sums[lane] = plus(sums[lane], sums[lane + reach]);
        }
    }
    if lane == 0u && large < pairs_of.larges {
        totals[large] = sums[0];
    }
}
// ANCHOR_END: large
