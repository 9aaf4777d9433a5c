// Scenes of space and of the plane.
import { BodyKind, Detail, GjkError, done, integer, write } from './core.js';
import * as records from './records.js';

const { Constants } = records;
const ROOM = 32;  // reports, or hits, of one call
const ALL = Object.freeze({});

// Many bodies, asked every tick which of them touch. Bodies are {slot, generation}.
export class Scene {
  constructor(home, shapes, { bodies, parts = bodies, ownPoses = parts, pairs = 16 * bodies, boxMargin = 0,
    detail = Detail.TOUCH, persist = false, retestAll = false, pairWords = 0, workspaceCells = 0, motions = 0 }) {
    const { of, call } = home, config = home.make(of.SceneConfig);
    this.owned = [config];
    this.home = home;
    this.shapes = [...shapes];
    const own = (record) => { this.owned.push(record); return record; };
    Object.assign(config, { bodies, parts, ownPoses, pairs, boxMargin, detail, persist: +persist, retestAll: +retestAll,
      pairWords, motions });
    const hasWorkspace = 'workspaceCells' in config;
    if (hasWorkspace) {
      config.workspaceCells = workspaceCells;
    }
    this.words = pairWords;
    this.record = own(home.make(of.Scene, 4 * shapes.length));
    this.reports = this.room(of.Report, own);
    this.manifolds = this.room(of.Manifold, own);
    this.hits = this.room(records.SceneHit, own);
    this.id = own(home.make(records.BodyId));
    this.state = own(home.make(of.BodyState));
    this.progress = own(home.make(records.Progress));
    this.counts = own(home.make(records.SceneStats));
    this.filter = own(home.make(records.SceneFilter));
    this.setup = own(home.make(of.BodySetup, 16 * of.Part.bytes));
    this.parts = Array.from({ length: 16 }, (_, i) =>
      new of.Part(home.memory, this.setup.at + of.BodySetup.bytes + of.Part.bytes * i));
    this.first = own(home.make(of.CastResult, 8));
    const bindings = own(home.make(of.SceneBindings));
    done(call.scene_bind_all(bindings.at));
    bindings.manifolds = this.manifolds[0].at;
    if (hasWorkspace) {
      bindings.workspace = own(home.room(Math.max(workspaceCells, 1))).at;
    }
    this.bindings = bindings;
    this.table = this.record.at + of.Scene.bytes;
    shapes.forEach((shape, i) => { home.memory.u32[this.table / 4 + i] = shape.record.at; shape.users++; });
    this.bytes = call.scene_bytes(config.at);
    this.block = this.bytes === 0 ? 0 : home.module.allocate(this.bytes);
    try {
      done(call.scene_init(this.record.at, config.at, this.block, this.bytes, this.table, shapes.length, bindings.at));
    } catch (error) {
      this.dispose();
      throw error;
    }
    // All that the scene is: copy it to save it.
    this.view = home.memory.u8.subarray(this.block, this.block + this.bytes);
  }

  room(of, own) {
    const { memory, at } = own(this.home.make(of, (ROOM - 1) * of.bytes));
    return Array.from({ length: ROOM }, (_, i) => new of(memory, at + of.bytes * i));
  }

  dispose() {
    this.owned.forEach((record) => this.home.release(record));
    this.home.module.exports.gjk_port_release(this.block);
    this.shapes.forEach((shape) => { shape.users--; });
    this.owned = this.shapes = [];
  }

  name({ slot, generation }) {
    this.id.slot = slot;
    this.id.generation = generation;
    return this.id.at;
  }

  // parts: the number of a shape, or up to 16 numbers and {shape, position, rotation} in the body's frame.
  add(parts, { position = this.home.upright.slice(0, this.home.size).fill(0), rotation = this.home.upright,
    kind = BodyKind.STATIC, detail = Detail.TOUCH, category = 1, mask = 0xFFFFFFFF, user = 0, margin = 0, slot = -1 } = {}) {
    const list = Array.isArray(parts) ? parts : [parts], { setup } = this;
    integer(list.length, 0, 16);
    list.forEach((part, i) => {
      const [to, own] = [this.parts[i], typeof part !== 'number'];
      to.shape = integer(own ? part.shape : part, 0, 65535);
      to.ownPose = own;
      write(to.pose.position, own ? part.position : position);
      write(to.pose.rotation, own && part.rotation || this.home.upright);
    });
    write(setup.pose.position, position);
    write(setup.pose.rotation, rotation);
    Object.assign(setup, { parts: this.parts[0].at, partCount: list.length, kind, detail, category, mask, user,
      margin: integer(margin) });
    done(slot < 0 ? this.home.call.scene_add(this.record.at, setup.at, this.id.at)
      : this.home.call.scene_add_at(this.record.at, slot, setup.at, this.id.at));
    return { slot: this.id.slot, generation: this.id.generation };
  }

  ask(call, ...rest) {
    done(call(this.record.at, ...rest));
  }

  remove(body) { this.ask(this.home.call.scene_remove, this.name(body)); }
  sleep(body) { this.ask(this.home.call.scene_sleep, this.name(body)); }
  wake(body) { this.ask(this.home.call.scene_wake, this.name(body)); }

  move(body, position, rotation = this.home.upright) {
    done(this.home.call.scene_move(this.record.at, this.name(body), this.home.pose(position, rotation)));
  }

  // For a body that does not go on the same way.
  teleport(body, position, rotation = this.home.upright) {
    done(this.home.call.scene_teleport(this.record.at, this.name(body), this.home.pose(position, rotation)));
  }

  setMotion(body, motion) { this.ask(this.home.call.scene_set_motion, this.name(body), integer(motion, 0, 255)); }
  setUser(body, user) { this.ask(this.home.call.scene_set_user, this.name(body), user); }
  // The next update tests all pairs of the body again: after a write to the cells of ground.
  refilter(body) { this.ask(this.home.call.scene_refilter, this.name(body)); }
  setFilter(body, category, mask) { this.ask(this.home.call.scene_set_filter, this.name(body), category, mask); }

  setShape(body, part, shape) {
    this.ask(this.home.call.scene_set_shape, this.name(body), integer(part, 0, 65535), integer(shape, 0, 65535));
  }

  // A BodyState, which stands until the next call of get.
  get(body) {
    return done(this.home.call.scene_get(this.record.at, this.name(body), this.state.at), this.state);
  }

  // Calls each(report, manifold, words) for all reports: records that stand during the call. manifold and words: null where
  // there are none.
  update(each) {
    const { record, reports, progress, home } = this;
    do {
      done(home.call.scene_update(record.at, reports[0].at, ROOM, progress.at));
      for (let i = 0; i < progress.reports; i++) {
        const report = reports[i], { manifold, words } = report;
        each(report, manifold === 0 ? null : this.manifolds[i],
          words === 0 ? null : home.memory.u32.subarray(words / 4, words / 4 + this.words));
      }
    } while (progress.pairsLeft !== 0 || progress.reportsLeft !== 0);
  }

  choose({ category = 0xFFFFFFFF, mask = 0xFFFFFFFF, ignore = { slot: 0, generation: 0 } }) {
    Object.assign(this.filter, { category, mask });
    this.filter.ignore.slot = ignore.slot;
    this.filter.ignore.generation = ignore.generation;
    return this.filter.at;
  }

  met(status) {
    done(status);
    const found = this.home.memory.u8[this.first.at + this.home.of.CastResult.bytes] !== 0;
    return found ? { hit: this.hits[0], result: this.first } : null;
  }

  // What a ray enters first, {hit, result}, which stand until the next cast; null: nothing.
  castRay(from, to, filter = ALL) {
    const { call, scratch, of } = this.home;
    const ends = [this.home.vector(from, scratch[0]), this.home.vector(to, scratch[1])];
    return this.met(call.scene_cast_ray(this.record.at, ...ends, this.choose(filter), this.hits[0].at, this.first.at,
      this.first.at + of.CastResult.bytes));
  }

  // What a collider meets first on a straight way.
  cast(collider, to, margin = 0, filter = ALL) {
    const { call, of } = this.home;
    return this.met(call.scene_cast(this.record.at, collider.record.at, this.home.vector(to), integer(margin),
      this.choose(filter), this.hits[0].at, this.first.at, this.first.at + of.CastResult.bytes));
  }

  // All parts that are at most reach away from a collider, in order: a list of {body, part, user}.
  within(collider, reach, filter = ALL) {
    const { call, memory } = this.home, chosen = this.choose(filter), found = [];
    let count = ROOM + 1;
    for (let after = 0; count > ROOM; after = this.hits[ROOM - 1].at) {
      done(call.scene_query_within(this.record.at, collider.record.at, integer(reach), chosen, after, this.hits[0].at, ROOM,
        this.progress.at));
      count = memory.u32[this.progress.at / 4];
      for (const { body: { slot, generation }, part, user } of this.hits.slice(0, count)) {
        found.push({ body: { slot, generation }, part, user });
      }
    }
    return found;
  }

  stats() {
    return done(this.home.call.scene_get_stats(this.record.at, this.counts.at), this.counts);
  }

  // 64 bits over all that decides further answers, a BigInt.
  hash() {
    done(this.home.call.scene_hash(this.record.at, this.first.at));
    return this.home.memory.u64[this.first.at / 8];
  }

  // A rollback: one copy of one ArrayBuffer, which may be one from before.
  save(into = new ArrayBuffer(this.bytes)) {
    new Uint8Array(into).set(this.view);
    return into;
  }

  // Takes what this scene, or one of the same configuration and shapes in the same module, has saved.
  load(save) {
    this.take(save, this.home.call.scene_attach);
  }

  // Marks the scene with a checksum, for a save that leaves this program: then save(), there open().
  seal() { this.ask(this.home.call.scene_seal); }

  // Takes a sealed save that may come from anywhere: it is checked. After an error the scene is as it was.
  open(save) {
    const before = this.save();
    try {
      this.take(save, this.home.call.scene_open);
    } catch (error) {
      this.load(before);
      throw error;
    }
  }

  take(save, call) {
    if (save.byteLength !== this.bytes) {
      throw new GjkError(Constants.GJK_ERROR_CAPACITY, null);
    }
    this.view.set(new Uint8Array(save));
    done(call(this.record.at, this.block, this.bytes, this.table, this.shapes.length, this.bindings.at));
  }
}
