// Numbers, statuses and memory, for the other files of this package.
import { Constants } from './records.js';

export const [Q16, Q30] = [Constants.GJK_Q16_ONE, Constants.GJK_Q30_ONE];
export const BodyKind = Object.freeze({ STATIC: 0, KINEMATIC: 1, DYNAMIC: 2 });
export const Detail = Object.freeze({ TOUCH: 0, DISTANCE: 1, DEPTH: 2, CONTACTS: 3, SENSOR: 4 });
export const Event = Object.freeze({ BEGIN: 1, PERSIST: 2, END: 3, IMPACT: 4 });
export const BodyMotion = Object.freeze({ NOT_KEPT: 0, KEPT: 1, FAST: 2 });

const STATUSES = Object.fromEntries(Object.entries(Constants).filter(([name]) => /^GJK_(OK|ERROR_.*)$/.test(name))
  .map(([name, value]) => [value, name]));

// A status that is not OK. partial: what the call has written; after ITERATION_LIMIT and CAPACITY the fields that the header
// of the query names are proven.
export class GjkError extends Error {
  constructor(status, partial) {
    super(STATUSES[status] || `status ${status}`);
    this.status = status;
    this.partial = partial;
  }
}

export function done(status, partial = null) {
  if (status !== 0) {
    throw new GjkError(status, partial);
  }
  return partial;
}

export class Memory {
  constructor(buffer) {
    this.buffer = buffer;
    this.i8 = new Int8Array(buffer);
    this.u8 = new Uint8Array(buffer);
    this.i16 = new Int16Array(buffer);
    this.u16 = new Uint16Array(buffer);
    this.i32 = new Int32Array(buffer);
    this.u32 = new Uint32Array(buffer);
    this.i64 = new BigInt64Array(buffer);
    this.u64 = new BigUint64Array(buffer);
  }
}

// What WebAssembly would cut off is refused.
export function integer(value, least = -(2 ** 31), most = 2 ** 31 - 1) {
  if (!Number.isInteger(value) || value < least || value > most) {
    throw new RangeError(`${value} is no integer from ${least} to ${most}`);
  }
  return value;
}

export function write(to, from) {
  if (from.length !== to.length) {
    throw new RangeError(`[${from}] has not ${to.length} numbers`);
  }
  for (let i = 0; i < to.length; i++) {
    to[i] = integer(from[i]);
  }
}
